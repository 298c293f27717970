package rasterlab.app.shell.tab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import javax.swing.JFrame;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.settings.LabTheme;

/** Tabs of a window that is open; skipped without a display. */
@Timeout(300)
class TabbedLabsTest {
    private final List<String> events = new CopyOnWriteArrayList<>();
    private final CountDownLatch mayGoOn = new CountDownLatch(1);
    private final List<LabTab> tabs =
            List.of(
                    tab("first", () -> {}),
                    tab("plain", () -> {}),
                    tab("slow", this::prepare),
                    tab("broken", this::fail),
                    new LabTab("faulty", "faulty", () -> {}, this::failAtFirst));
    private final List<String> failures = new CopyOnWriteArrayList<>();
    private TabbedLabs pane;
    private WindowKeys keys;
    private JFrame frame;

    @BeforeEach
    void open() throws Exception {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    pane =
                            new TabbedLabs(
                                    tabs,
                                    failure -> failures.add(failure.getMessage()),
                                    Texts.of("shell", Language.ENGLISH));
                    keys = new WindowKeys(pane);
                    pane.bindSteps(keys);
                    pane.fill();
                    frame = new JFrame();
                    frame.setContentPane(pane);
                    frame.setSize(400, 300);
                    frame.setVisible(true);
                    events.clear();
                });
    }

    @AfterEach
    void close() throws Exception {
        if (frame != null) EventQueue.invokeAndWait(frame::dispose);
    }

    private LabTab tab(String name, Runnable preparation) {
        return new LabTab(name, name, preparation, () -> new Lab(name));
    }

    private final class Lab extends LabPanel {
        private static final long serialVersionUID = 1L;

        Lab(String name) {
            setName(name);
            events.add(name + " is begun");
        }

        @Override
        public List<Runnable> parts() {
            return List.of(() -> events.add(getName() + " is made"));
        }

        @Override
        public void refresh() {
            events.add(getName() + " is filled");
        }

        @Override
        public void focusPicture() {}

        @Override
        public void close() {}
    }

    private void prepare() {
        try {
            mayGoOn.await();
        } catch (InterruptedException e) {
            throw new IllegalStateException(e);
        }
        events.add("prepared " + (EventQueue.isDispatchThread() ? "by events" : "beside events"));
    }

    private void fail() {
        throw new IllegalStateException("not prepared");
    }

    private LabPanel failAtFirst() {
        return failures.isEmpty() ? notMade() : new Lab("faulty");
    }

    private static LabPanel notMade() {
        throw new IllegalStateException("not made");
    }

    private void choose(String... names) throws Exception {
        EventQueue.invokeAndWait(() -> List.of(names).forEach(pane::show));
    }

    private int selected() throws Exception {
        var selected = new int[1];
        EventQueue.invokeAndWait(() -> selected[0] = pane.getSelectedIndex());
        return selected[0];
    }

    /** Waits until that tab is shown. */
    private void await(int index) throws Exception {
        while (selected() != index) Thread.onSpinWait();
        EventQueue.invokeAndWait(() -> {});
    }

    @Test
    void panelIsMadeFilledLaidOutAndShownInEventsOfTheirOwn() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    pane.show("plain");
                    note();
                });
        await(1);
        assertEquals(
                List.of(
                        "before",
                        "plain is begun",
                        "before",
                        "plain is made",
                        "before",
                        "plain is filled",
                        "before",
                        "laid out",
                        "shown"),
                withoutRepeats(events));
    }

    /** Swing may lay it out in an event of its own besides, or not. */
    private static List<String> withoutRepeats(List<String> events) {
        var turns = new ArrayList<String>();
        for (String event : events)
            if (turns.isEmpty() || !turns.get(turns.size() - 1).equals(event)) turns.add(event);
        return turns;
    }

    /** Notes in each event what is there, until the plain tab is shown. */
    private void note() {
        if (pane.getSelectedIndex() == 1) {
            events.add("shown");
            return;
        }
        var place = (Container) pane.getComponentAt(1);
        boolean large = place.getComponentCount() == 1 && place.getComponent(0).getWidth() > 0;
        events.add(large ? "laid out" : "before");
        EventQueue.invokeLater(this::note);
    }

    @Test
    void windowAnswersWhileATabIsPrepared() throws Exception {
        choose("slow");
        for (int k = 0; k < 9; k++) assertEquals(0, selected());
        assertEquals(List.of(), events);
        mayGoOn.countDown();
        await(2);
        assertEquals(
                List.of(
                        "prepared beside events",
                        "slow is begun",
                        "slow is made",
                        "slow is filled"),
                events);
    }

    @Test
    void panelIsMadeThoughItsPreparationFailed() throws Exception {
        choose("broken");
        await(3);
        assertEquals(List.of("broken is begun", "broken is made", "broken is filled"), events);
    }

    @Test
    void tabThatIsNotWantedAnyMoreIsNotMade() throws Exception {
        choose("slow", "plain", "first", "broken");
        mayGoOn.countDown();
        await(3);
        while (!events.contains("prepared beside events")) selected();
        for (int k = 0; k < 9; k++) assertEquals(3, selected());
        assertEquals(
                List.of(
                        "broken is begun",
                        "broken is filled",
                        "broken is made",
                        "prepared beside events"),
                events.stream().sorted().toList());
    }

    @Test
    void tabThatIsChosenAgainBeforeItIsThereIsMadeOnce() throws Exception {
        choose("plain", "first", "plain");
        while (selected() != 1 && failures.isEmpty()) Thread.onSpinWait();
        EventQueue.invokeAndWait(() -> {});
        assertEquals(List.of(), failures);
        assertEquals(List.of("plain is begun", "plain is made", "plain is filled"), events);
    }

    @Test
    void windowClosedMeanwhileMakesNoPanel() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    pane.show("plain");
                    frame.dispose();
                });
        for (int k = 0; k < 9; k++) assertEquals(0, selected());
        assertEquals(List.of(), events);
    }

    @ParameterizedTest(name = "{0} counts from the tab that is seen")
    @CsvSource({"ctrl TAB, 3", "ctrl PAGE_DOWN, 3", "ctrl shift TAB, 2", "ctrl PAGE_UP, 2"})
    void quickKeysCountFromTheTabThatIsComing(String key, int reached) throws Exception {
        mayGoOn.countDown();
        while (!frame.isFocused()) Thread.onSpinWait();
        EventQueue.invokeAndWait(
                () -> {
                    for (int k = 0; k < 3; k++) press(KeyStroke.getKeyStroke(key));
                    assertEquals(tabs.get(reached), pane.chosen());
                });
        await(reached);
        assertFalse(events.contains("plain is made"), "made in passing");
    }

    private void press(KeyStroke key) {
        boolean taken =
                keys.dispatchKeyEvent(
                        new KeyEvent(
                                pane,
                                KeyEvent.KEY_PRESSED,
                                0,
                                key.getModifiers(),
                                key.getKeyCode(),
                                KeyEvent.CHAR_UNDEFINED));
        assertTrue(taken, "not a key of the window");
    }

    @Test
    void quickArrowsOnTheStripCountFromTheTabThatIsComing() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    for (int k = 0; k < 3; k++)
                        pane.getActionMap()
                                .get("navigateRight")
                                .actionPerformed(new ActionEvent(pane, 0, ""));
                    assertEquals(tabs.get(3), pane.chosen());
                });
        await(3);
        assertEquals(List.of("broken is begun", "broken is made", "broken is filled"), events);
    }

    @Test
    void panelThatCannotBeMadeLeavesTheTabThatIsSeen() throws Exception {
        choose("faulty");
        while (failures.isEmpty()) Thread.onSpinWait();
        EventQueue.invokeAndWait(() -> assertEquals(pane.seen(), pane.chosen()));
        assertEquals(0, selected());
        assertEquals(List.of("not made"), failures);
        choose("faulty");
        await(4);
        assertEquals(List.of("faulty is begun", "faulty is made", "faulty is filled"), events);
    }

    @Test
    void windowOpensThoughTheFirstPanelCannotBeMade() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var faulty = new LabTab("f", "f", () -> {}, TabbedLabsTest::notMade);
                    var opened =
                            new TabbedLabs(
                                    List.of(faulty),
                                    failure -> failures.add(failure.getMessage()),
                                    Texts.of("shell", Language.ENGLISH));
                    opened.fill();
                    opened.focusPicture();
                });
        assertEquals(List.of("not made"), failures);
    }
}
