// How numbers are shown: decimals and the unit of angles.
import { digitChoices, unitChoices } from "../../model/page_state.ts";
import { chooseDigits, chooseUnit } from "../../state/settings.ts";
import type { Store } from "../../state/store.ts";
import {
  anglesLabel,
  decimalsLabel,
  digitsWords,
  unitNames,
  unitWords,
} from "../../words/settings.ts";
import { SettingChoice } from "./SettingChoice.tsx";
import "./number_settings.css";

/** How numbers are shown. */
export function NumberSettings({ store }: { store: Store }) {
  const { digits, unit } = store.state.value;
  return (
    <div class="number-settings">
      <SettingChoice
        name="unit"
        // The units say of what they are.
        label={<span class="visually-hidden">{anglesLabel}</span>}
        choices={unitChoices}
        chosen={unit}
        words={unitWords}
        names={unitNames}
        onChoose={(chosen) => chooseUnit(store, chosen)}
      />
      <SettingChoice
        name="digits"
        label={decimalsLabel}
        choices={digitChoices}
        chosen={digits}
        words={digitsWords}
        onChoose={(chosen) => chooseDigits(store, chosen)}
      />
    </div>
  );
}
