// The one live region of the page: what was done, at once, and the result, once it rests.
import { useEffect, useState } from "preact/hooks";
import type { PageState } from "../../model/page_state.ts";
import { announcement, isAnnouncementShown } from "../../state/announcement.ts";
import "./announcements.css";

/** So long nothing changes before it is said: whoever types or turns hears the end of it once. */
const restMs = 500;

export function Announcements({ result, of }: { result: string; of: PageState }) {
  const isShown = isAnnouncementShown.value;
  // Of the two only the one that changes is read out; an empty text would be written with every change.
  return (
    <div role="status" aria-live="polite" aria-atomic="false">
      <div class={isShown ? "said" : "visually-hidden"} data-said="done">
        {announcement.value || null}
      </div>
      <Result words={result} of={of} />
    </div>
  );
}

function Result({ words, of }: { words: string; of: PageState }) {
  const [said, setSaid] = useState(words);
  // Again with every change, also where the words stay: that of a bracket which is not closed yet.
  useEffect(() => {
    const timer = setTimeout(() => setSaid(words), restMs);
    return () => clearTimeout(timer);
  }, [words, of]);
  return (
    <div class="visually-hidden" data-said="result">
      {said || null}
    </div>
  );
}
