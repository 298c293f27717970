package rasterlab.app.shell;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.practice.PracticeCards;
import rasterlab.app.shell.labs.TabRooms;

/**
 * Lists what can be done in a tab, and by which keys.
 *
 * @param title names the tab
 * @param sections those of the tab first, then what works everywhere
 */
record HelpText(String title, List<Section> sections) {
    HelpText {
        sections = List.copyOf(sections);
    }

    /** Some ways under a heading. */
    record Section(String heading, List<HelpEntry> ways) {
        Section {
            ways = List.copyOf(ways);
        }
    }

    /** A key or a movement of the mouse, and what it does. */
    record HelpEntry(String by, String does) {}

    /**
     * @param stage key of the stage that is seen in the tab; one that has no ways of its own has
     *     those of the tab
     */
    static HelpText of(String tab, String stage, Language language) {
        Texts texts = Texts.of("shell", "help", language);
        String name = Texts.of("shell", language).text("tab." + tab);
        List<HelpEntry> own = ways(texts, stage);
        List<HelpEntry> ofTab = own.isEmpty() ? ways(texts, tab) : own;
        boolean asks = stage.equals(PracticeCards.HELP);
        var sections = new ArrayList<Section>();
        sections.add(new Section(texts.text(asks ? "heading.practice" : "heading.tab"), ofTab));
        if (!asks && TabRooms.namedOrFirst(tab).playsSteps())
            sections.add(new Section(texts.text("heading.player"), ways(texts, "player")));
        sections.add(new Section(texts.text("heading.window"), ways(texts, "window")));
        return new HelpText(texts.text("title", name), sections);
    }

    private static List<HelpEntry> ways(Texts texts, String part) {
        var ways = new ArrayList<HelpEntry>();
        for (int i = 1; texts.has(part + "." + i + ".by"); i++) {
            String key = part + "." + i;
            ways.add(new HelpEntry(texts.text(key + ".by"), texts.text(key + ".does")));
        }
        return ways;
    }
}
