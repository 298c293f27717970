package rasterlab.app.shell.tab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.language.Language;
import rasterlab.app.shell.LabTabs;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.settings.LabTheme;

@Tag("slow")
class LabTabTest {
    private final List<String> events = new ArrayList<>();
    private final LabTab tab = new LabTab("lab", "Lab", () -> {}, Lab::new);
    private boolean fails;

    private final class Lab extends LabPanel {
        private static final long serialVersionUID = 1L;

        Lab() {
            events.add("begun");
        }

        @Override
        public List<Runnable> parts() {
            return List.of(() -> events.add("first"), this::second);
        }

        private void second() {
            if (fails) throw new IllegalStateException("not made");
            events.add("second");
        }

        @Override
        public void refresh() {
            events.add("filled");
        }

        @Override
        public Dimension getPreferredSize() {
            events.add("measured");
            return super.getPreferredSize();
        }

        @Override
        public void focusPicture() {}

        @Override
        public void close() {
            events.add("closed");
        }
    }

    @Test
    void labIsNotWholeBeforeItShowsWhatItsModelHasAndIsMeasured() {
        for (int part = 0; part < 5; part++) {
            assertFalse(tab.isWhole(), "after " + events);
            tab.makePart();
        }
        assertTrue(tab.isWhole());
        assertEquals(List.of("begun", "first", "second", "filled", "measured"), events);
    }

    @Test
    void labThatIsAskedForHalfMadeIsFinishedAndStaysTheSame() {
        tab.makePart();
        tab.makePart();
        assertEquals(tab.panel(), tab.panel());
        assertEquals(List.of("begun", "first", "second", "filled", "measured"), events);
    }

    @Test
    void partThatFailsLeavesNothingOfTheLab() {
        fails = true;
        assertThrows(IllegalStateException.class, tab::panel);
        fails = false;
        tab.panel();
        assertEquals(
                List.of(
                        "begun",
                        "first",
                        "closed",
                        "begun",
                        "first",
                        "second",
                        "filled",
                        "measured"),
                events);
    }

    @Test
    void eachPartIsMadeInAnEventOfItsOwn() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    tab.makeInEvents(() -> events.add("then"));
                    note();
                });
        letEventsPass();
        assertEquals(
                List.of(
                        "-",
                        "begun",
                        "-",
                        "first",
                        "-",
                        "second",
                        "-",
                        "filled",
                        "-",
                        "measured",
                        "-",
                        "then"),
                events);
    }

    /** Notes in each event what is there, until the lab is whole. */
    private void note() {
        events.add("-");
        if (!tab.isWhole()) EventQueue.invokeLater(this::note);
    }

    @Test
    void partThatFailsInItsEventFailsAgainForWhoAsks() throws Exception {
        fails = true;
        EventQueue.invokeAndWait(() -> tab.makeInEvents(() -> events.add("then")));
        letEventsPass();
        assertEquals(List.of("begun", "first", "closed", "then"), events);
        assertThrows(IllegalStateException.class, tab::panel);
    }

    @Test
    void closedLabIsMadeNoFurther() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    tab.makeInEvents(() -> events.add("then"));
                    tab.close();
                });
        letEventsPass();
        assertEquals(List.of("then"), events);
    }

    /** Lets more events pass than the lab is made in. */
    private static void letEventsPass() throws Exception {
        for (int k = 0; k < 9; k++) EventQueue.invokeAndWait(() -> {});
    }

    @ParameterizedTest(name = "{0} is closed while it is half made")
    @FieldSource("rasterlab.app.shell.LabTabs#NAMES")
    void everyLabCanBeClosedAfterEachOfItsParts(String name) throws Exception {
        var failures = new ArrayList<Throwable>();
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    try (var models = LabModels.first(failures::add)) {
                        for (int parts = 1; !closed(models, name, parts); parts++) {}
                    }
                });
        assertEquals(List.of(), failures);
    }

    /** Whether so many parts made it whole. */
    private static boolean closed(LabModels models, String name, int parts) {
        try (var tabs = LabTabs.create(models, Language.ENGLISH, failure -> {})) {
            LabTab tab = tabs.named(name);
            for (int part = 0; part < parts; part++) tab.makePart();
            return tab.isWhole();
        }
    }
}
