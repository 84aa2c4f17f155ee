// A field to find a library by typing: a combobox with a list, after the pattern of WAI-ARIA.
import { useEffect, useId, useRef, useState } from "preact/hooks";
import type { Endpoint, Engine, Library } from "../../engine.ts";
import { groupNames } from "../../words/library_behaviour.ts";
import * as words from "../../words/translate/library_picker.ts";
import { aboutLibrary, endName, groups } from "../parts/library.ts";
import { found } from "../parts/library_search.ts";
import "./library_picker.css";

/** What the list offers beside libraries. */
export type Convened = "hamilton" | "jpl" | "custom";

interface Option {
  key: string;
  name: string;
  about: string;
  choose: () => void;
}

interface Section {
  name: string;
  options: Option[];
}

const pageOfOptions = 8;

export function LibraryPicker({
  engine,
  label,
  end,
  choose,
  convene,
}: {
  engine: Engine;
  label: string;
  end: Endpoint;
  choose: (id: string) => void;
  convene: (kind: Convened) => void;
}) {
  const id = useId();
  const [isOpen, setOpen] = useState(false);
  /** What was typed since the list was opened; nothing while the name of the end stands there. */
  const [typed, setTyped] = useState<string | undefined>(undefined);
  const [at, setAt] = useState(0);
  const input = useRef<HTMLInputElement>(null);
  const list = useRef<HTMLDivElement>(null);
  const asked = typed ?? "";
  const name = endName(end, engine);
  const sections = isOpen ? sectionsFor(asked, engine, choose, convene) : [];
  const options = sections.flatMap((section) => section.options);
  const active = options[at];

  useEffect(() => {
    list.current?.querySelector('[aria-selected="true"]')?.scrollIntoView({ block: "nearest" });
  }, [at, typed, isOpen]);

  const open = (text?: string) => {
    setOpen(true);
    setTyped(text);
    const all = sectionsFor(text ?? "", engine, choose, convene);
    const keys = all.flatMap((section) => section.options).map((option) => option.key);
    setAt(text === undefined ? Math.max(0, keys.indexOf(keyOf(end, engine))) : 0);
  };
  const close = () => {
    setOpen(false);
    setTyped(undefined);
  };
  const take = (option: Option | undefined) => {
    if (option === undefined) return;
    close();
    option.choose();
  };
  const moveTo = (to: number) => setAt(Math.min(Math.max(to, 0), options.length - 1));
  const onKeyDown = (event: KeyboardEvent) => {
    const moves: Record<string, number> = {
      ArrowDown: at + 1,
      ArrowUp: at - 1,
      PageDown: at + pageOfOptions,
      PageUp: at - pageOfOptions,
      Home: 0,
      End: options.length - 1,
    };
    const to = moves[event.key];
    if (!isOpen && (event.key === "ArrowDown" || event.key === "ArrowUp")) open();
    else if (isOpen && to !== undefined) moveTo(to);
    else if (isOpen && event.key === "Enter") take(active);
    else if (isOpen && event.key === "Escape") close();
    else return;
    event.preventDefault();
  };

  return (
    <div class="picker">
      <label for={`${id}-input`} class="picker-label">
        {label}
      </label>
      <div class="picker-box">
        <input
          id={`${id}-input`}
          ref={input}
          type="text"
          role="combobox"
          // What is typed here is no part of the state until something is picked.
          data-undo="own"
          aria-expanded={isOpen}
          aria-controls={`${id}-list`}
          aria-autocomplete="list"
          aria-activedescendant={isOpen && active ? `${id}-${active.key}` : undefined}
          autocomplete="off"
          autocapitalize="off"
          spellcheck={false}
          value={typed ?? name}
          onFocus={(event) => event.currentTarget.select()}
          onClick={() => isOpen || open()}
          onInput={(event) => open(event.currentTarget.value)}
          onKeyDown={onKeyDown}
          onBlur={close}
        />
        <svg class="picker-arrow" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
          <path d="M4 6.5 L8 10.5 L12 6.5" />
        </svg>
      </div>
      <div
        id={`${id}-list`}
        ref={list}
        class="picker-list"
        role="listbox"
        aria-label={words.list(label)}
        hidden={!isOpen}
        // A click in the list must not take the focus from the field.
        onMouseDown={(event) => event.preventDefault()}
      >
        {sections.map((section, number) => (
          <fieldset key={section.name} aria-labelledby={`${id}-group-${number}`}>
            <div id={`${id}-group-${number}`} class="picker-group" role="presentation">
              {section.name}
            </div>
            {section.options.map((option) => (
              <div
                key={option.key}
                id={`${id}-${option.key}`}
                class="picker-option"
                role="option"
                tabIndex={-1}
                aria-selected={option === active}
                onClick={() => take(option)}
                onKeyDown={onKeyDown}
              >
                <span class="picker-name">{option.name}</span>
                <span class="picker-about">{option.about}</span>
              </div>
            ))}
          </fieldset>
        ))}
        {isOpen && options.length === 0 && (
          <div
            class="picker-none"
            role="option"
            aria-selected={false}
            aria-disabled="true"
            tabIndex={-1}
          >
            {words.none(asked)}
          </div>
        )}
      </div>
    </div>
  );
}

function sectionsFor(
  asked: string,
  engine: Engine,
  choose: (id: string) => void,
  convene: (kind: Convened) => void,
): Section[] {
  const libraryOption = (library: Library): Option => ({
    key: library.id,
    name: library.name,
    about: aboutLibrary(library, engine),
    choose: () => choose(library.id),
  });
  const convened: Section = {
    name: words.conventions,
    options: (Object.keys(words.convention) as Convened[])
      .map((key) => ({ key, ...words.convention[key] }))
      .filter(({ name, about }) => fits(`${name} ${about} ${words.conventionWord}`, asked))
      .map(({ key, name, about }) => ({ key: `:${key}`, name, about, choose: () => convene(key) })),
  };
  const libraries = found(engine.libraries, asked, (library) => aboutLibrary(library, engine));
  const sections: Section[] =
    asked.trim() === ""
      ? groups.map((group) => ({
          name: groupNames[group],
          options: libraries.filter((library) => library.group === group).map(libraryOption),
        }))
      : [{ name: words.libraries, options: libraries.map(libraryOption) }];
  return [convened, ...sections].filter((section) => section.options.length > 0);
}

const fits = (text: string, asked: string) =>
  asked
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.toLowerCase().includes(word));

function keyOf(end: Endpoint, engine: Engine): string {
  if (end.kind === "library") return end.id;
  const { named } = engine.describe(end.convention);
  return named === "hamilton" || named === "jpl" ? `:${named}` : ":custom";
}
