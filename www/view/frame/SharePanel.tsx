// The link, the link as Markdown and the sentence that cites the case. Loaded when it is opened.
import { version } from "../../../package.json";
import { citeCompose, citeRead, citeTranslation, markdownLink } from "../../copy/cite.ts";
import { putOnClipboard } from "../../dom/clipboard.ts";
import { announceVisibly } from "../../state/announcement.ts";
import type { Store } from "../../state/store.ts";
import { citeWords } from "../../words/copy/citation.ts";
import { panelWords as words } from "../../words/frame/share_panel.ts";
import { Popup } from "../parts/Popup.tsx";
import { caseTitle, current, endNameOf, sharedAddress } from "./case_title.ts";
import "./share_panel.css";

export interface PanelProps {
  store: Store;
  anchor: HTMLElement;
  close: () => void;
}

export function SharePanel({ store, anchor, close }: PanelProps) {
  const link = sharedAddress(store);
  const sentence = sentenceOf(store);
  return (
    <Popup anchor={anchor} close={close} role="dialog" label={words.panel} kind="share-panel">
      <Line name={words.link} text={link} />
      <Line name={words.markdown} text={markdownLink(caseTitle(store), link)} />
      {sentence === undefined ? null : sentence === "" ? (
        <p>{words.noCase}</p>
      ) : (
        <Line name={words.citation} text={citeWords.source(sentence, version, link)} />
      )}
    </Popup>
  );
}

function Line({ name, text }: { name: string; text: string }) {
  const copy = async () => {
    const isAllowed = await putOnClipboard(text);
    announceVisibly(isAllowed ? words.copied(name) : words.notAllowed(name));
  };
  return (
    <button type="button" aria-label={words.copy(name)} onClick={copy}>
      <strong>{name}</strong>
      <svg viewBox="0 0 16 16" width="14" height="14" aria-hidden="true">
        <path d="M5.5 5.5 h7 v8 h-7 z M10.5 5.5 v-3 h-7 v8 h2" />
      </svg>
      <span class="share-text">{text}</span>
    </button>
  );
}

/** The sentence of a view that shows a case: empty while its text has a problem. */
function sentenceOf(store: Store): string | undefined {
  const { view, from, to } = store.state.value;
  switch (view) {
    case "read":
      return current(store.read.value, citeRead) ?? "";
    case "compose":
      return current(store.compose.value, citeCompose) ?? "";
    case "translate":
      return (
        current(store.translate.value, (report) =>
          citeTranslation(report, { from: endNameOf(from, store), to: endNameOf(to, store) }),
        ) ?? ""
      );
    default:
      return undefined;
  }
}
