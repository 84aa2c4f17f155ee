// What a state of the page asks the core, in whichever view, without the files of the views.
import type { Request } from "../../../www/engine.ts";
import type { PageState } from "../../../www/model/page_state.ts";
import { asksOf, requestOf } from "../../../www/state/store.ts";
import { askedOfIdentify } from "../../../www/view/identify/asked.ts";
import { askedOfTranslate } from "../../../www/view/translate/asked.ts";

asksOf.value = { translate: askedOfTranslate, identify: askedOfIdentify };

export const askedOf = (state: PageState): Request | undefined => requestOf(state);
