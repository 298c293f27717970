// Keeps the part of the page that is marked `data-events` up to date: whenever the server reports
// something new, the part is fetched again as HTML that the server has escaped. Copies the command before a
// button "copy" where the browser lets it; elsewhere there is no such button.
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

if (navigator.clipboard) {
  document.documentElement.classList.add("copies");
  document.addEventListener("click", (event) => {
    if (event.target.matches(".copy")) navigator.clipboard.writeText(event.target.previousElementSibling.innerText);
  });
}
