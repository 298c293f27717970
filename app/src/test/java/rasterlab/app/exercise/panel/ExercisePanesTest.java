package rasterlab.app.exercise.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.EventQueue;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;

/** The rooms of a tab that is made again, as another language or theme has it. */
class ExercisePanesTest {
    /** The things that one tab leaves to the next one of its window. */
    private final SavedExercisePanes kept = new SavedExercisePanes();

    @BeforeAll
    static void look() throws Exception {
        EventQueue.invokeAndWait(LabTheme.LIGHT::install);
    }

    private ExercisePanes made(Language language) throws Exception {
        var made = new AtomicReference<ExercisePanes>();
        EventQueue.invokeAndWait(
                () ->
                        made.set(
                                new ExercisePanes(
                                        Texts.of("exercise", language),
                                        kept,
                                        new JPanel(),
                                        new JPanel(),
                                        new JPanel())));
        return made.get();
    }

    private static void paintLarge(ExercisePanes rooms) throws Exception {
        for (int round = 0; round < 2; round++) OffscreenPainter.paint(rooms, 1280, 740);
    }

    private static void paintSmall(ExercisePanes rooms) throws Exception {
        for (int round = 0; round < 2; round++) OffscreenPainter.paint(rooms, 600, 400);
    }

    private static JSplitPane divided(ExercisePanes rooms) {
        return (JSplitPane) rooms.getComponent(0);
    }

    private static JSplitPane lower(ExercisePanes rooms) {
        return (JSplitPane) divided(rooms).getRightComponent();
    }

    private static void drag(JSplitPane pane, int to) throws Exception {
        EventQueue.invokeAndWait(() -> pane.setDividerLocation(to));
    }

    @Test
    void dividersStayWhereTheyWereDragged() throws Exception {
        ExercisePanes first = made(Language.ENGLISH);
        paintLarge(first);
        drag(divided(first), 300);
        drag(lower(first), 500);
        paintLarge(first);
        ExercisePanes again = made(Language.RUSSIAN);
        paintLarge(again);
        assertEquals(300, divided(again).getDividerLocation(), 2);
        assertEquals(500, lower(again).getDividerLocation(), 2);
    }

    @Test
    void dividersComeBackWithTheRoomForThem() throws Exception {
        ExercisePanes rooms = made(Language.ENGLISH);
        paintLarge(rooms);
        drag(divided(rooms), 300);
        paintLarge(rooms);
        paintSmall(rooms);
        paintLarge(rooms);
        assertEquals(300, divided(rooms).getDividerLocation(), 2);
    }

    @Test
    void roomThatWasLookedAtIsStillInSight() throws Exception {
        ExercisePanes first = made(Language.ENGLISH);
        paintSmall(first);
        EventQueue.invokeAndWait(() -> first.show(ExercisePanes.Room.PROGRAM));
        ExercisePanes again = made(Language.RUSSIAN);
        paintSmall(again);
        int shown = ((JTabbedPane) again.getComponent(0)).getSelectedIndex();
        assertEquals(ExercisePanes.Room.PROGRAM.ordinal(), shown);
    }

    @Test
    @DisplayName("titles within a tab are larger than that of the tab")
    void titlesAreAsLargeAsThoseAround() throws Exception {
        ExercisePanes rooms = made(Language.ENGLISH);
        var around = new JTabbedPane();
        EventQueue.invokeAndWait(
                () -> {
                    around.setFont(around.getFont().deriveFont(9f));
                    around.add(rooms);
                });
        for (int round = 0; round < 2; round++) OffscreenPainter.paint(around, 600, 400);
        assertEquals(around.getFont(), rooms.getComponent(0).getFont());
    }

    @Test
    void firstRoomIsLookedAtWithoutBeingChosen() throws Exception {
        paintSmall(made(Language.ENGLISH));
        assertEquals(Optional.of(ExercisePanes.Room.STATEMENT), kept.chosen());
    }
}
