// Keeps the part of the page that is marked `data-events` up to date: whenever the server reports
// something new, the part is fetched again as HTML that the server has escaped. Copies the command before a
// button "copy" where the browser lets it; elsewhere there is no such button. Keeps what was typed when the
// language changes. Sends the form that is marked `data-send`.
"use strict";

const live = document.querySelector("[data-events]");

if (live) {
  let fetching = false;
  let again = false;

  const refresh = async () => {
    if (fetching) {
      again = true;
      return;
    }
    fetching = true;
    try {
      do {
        again = false;
        const answer = await fetch(live.dataset.fragment, { credentials: "same-origin" });
        if (answer.ok) replace(await answer.text());
      } while (again);
    } finally {
      fetching = false;
    }
  };

  const replace = (html) => {
    const open = [...live.querySelectorAll("details")].map((part) => part.open);
    const fresh = new DOMParser().parseFromString(html, "text/html").body.firstElementChild;
    fresh.querySelectorAll("details").forEach((part, i) => { part.open = open[i] === true; });
    live.replaceChildren(...fresh.childNodes);
  };

  const events = new EventSource(live.dataset.events);
  events.addEventListener("position", refresh);
  events.addEventListener("case", refresh);
  events.addEventListener("changed", refresh);
  events.addEventListener("done", () => {
    events.close();
    refresh();
  });
}

// Another language begins with what was typed: the form is sent to be shown again, not handed in.
const changed = (field) => {
  if (field.type === "file") return field.files.length > 0;
  if (field.options) return [...field.options].some((one) => one.selected && !one.defaultSelected && one.value);
  return "defaultValue" in field && field.value !== field.defaultValue;
};

document.addEventListener("click", (event) => {
  const link = event.target.closest("a[hreflang]");
  const form = link && [...document.querySelectorAll("#steps, #whole")].find((one) => [...one.elements].some(changed));
  if (!form) return;
  event.preventDefault();
  const again = document.createElement("button");
  again.hidden = true;
  again.name = "again";
  again.value = "true";
  again.formAction = link.href;
  again.formNoValidate = true;
  form.append(again);
  again.click();
});

// An answer for another server goes there by itself; elsewhere its button sends it.
document.querySelector("form[data-send]")?.requestSubmit();

// A link with a token fills the field, so that whoever follows it only presses the button. What stands behind # is never sent.
const token = new URLSearchParams(location.hash.slice(1)).get("token");
const tokenField = document.querySelector("form[action='/sign-in'] [name=token]");
if (token && tokenField) {
  tokenField.value = token;
  history.replaceState(null, "", location.pathname);
  tokenField.form.querySelector("button").focus();
}

// Another may sign in here next, so what editor.js keeps goes with who typed it.
document.querySelector("form[action='/sign-out']")?.addEventListener("submit", () => {
  Object.keys(localStorage).filter((name) => name.startsWith("typed ")).forEach((name) => localStorage.removeItem(name));
});

if (navigator.clipboard) {
  document.documentElement.classList.add("copies");
  document.addEventListener("click", (event) => {
    if (event.target.matches(".copy")) navigator.clipboard.writeText(event.target.previousElementSibling.innerText);
  });
}
