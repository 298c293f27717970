package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static rasterlab.app.exercise.ShownResult.named;

import java.awt.Component;
import java.awt.EventQueue;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import javax.swing.JButton;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.exercise.panel.ExercisePanel;
import rasterlab.app.exercise.panel.ExercisePanes;
import rasterlab.app.exercise.panel.WindowEditor;
import rasterlab.app.language.Language;
import rasterlab.app.server.CourseServer;
import rasterlab.app.server.FakeServer;
import rasterlab.app.shell.OffscreenPainter;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.catalogue.Catalogue;

/** Work beside a server that takes everything and says nothing, in a window without much room. */
@Timeout(300)
class FoldedRoomsTest {
    private static final Duration PATIENCE = Duration.ofMinutes(2);

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final CountDownLatch end = new CountDownLatch(1);
    private FakeServer mute;
    private ExerciseLabModel model;
    private ExercisePanel panel;

    @BeforeEach
    void open() throws Exception {
        mute = new FakeServer();
        mute.on("POST /api/v1/join", exchange -> hold());
        mute.on("GET /api/v1/exercises", 200, "[]");
        mute.on("POST /api/v1/exercises/line-bresenham/submissions", exchange -> hold());
        EventQueue.invokeAndWait(
                () -> {
                    ShownResult.install(LabTheme.PROJECTOR, 19);
                    model =
                            new ExerciseLabModel(
                                    () -> List.copyOf(Catalogue.builtIn().all()),
                                    new CourseServer.ServerTimeouts(PATIENCE, PATIENCE, PATIENCE),
                                    EventQueue::invokeLater,
                                    failures::add);
                    var editor = new WindowEditor();
                    editor.rooms().choose(ExercisePanes.Room.PROGRAM);
                    panel =
                            new ExercisePanel(
                                    model,
                                    editor,
                                    ShownResult.NOWHERE,
                                    Language.ENGLISH,
                                    failures::add);
                    panel.parts().forEach(Runnable::run);
                    panel.refresh();
                });
        paint();
    }

    private void hold() {
        try {
            end.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    @AfterEach
    void close() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    panel.close();
                    model.close();
                    LabTheme.LIGHT.install();
                });
        end.countDown();
        mute.close();
        assertEquals(List.of(), failures);
    }

    private void paint() throws Exception {
        for (int round = 0; round < 2; round++) OffscreenPainter.paint(panel, 900, 538);
    }

    private int room() {
        return ((JTabbedPane) named(panel, "rooms")).getSelectedIndex();
    }

    @Test
    @DisplayName("joining a course turns to the result, or cannot be given up, or is not told")
    void joiningStaysBesideWhatGivesItUp() throws Exception {
        EventQueue.invokeAndWait(() -> model.enrolment().join(mute.address(), "CODE", "Ann"));
        paint();
        EventQueue.invokeAndWait(
                () -> {
                    assertEquals(ExercisePanes.Room.PROGRAM.ordinal(), room());
                    var notice = (JTextArea) named(panel, "notice");
                    assertTrue(notice.isVisible());
                    assertEquals("Joining the course…", notice.getText());
                    ((JButton) named(panel, "cancel")).doClick();
                    assertFalse(model.state().work().running());
                });
    }

    @Test
    @DisplayName("a submission cannot be given up beside the result it turns to")
    void submissionIsGivenUpBesideTheResult() throws Exception {
        var known = new CountDownLatch(1);
        EventQueue.invokeAndWait(
                () -> {
                    model.listen(state -> state.account().ifPresent(account -> known.countDown()));
                    model.enrolment().signIn(mute.address(), "token");
                });
        known.await();
        EventQueue.invokeAndWait(model::submit);
        paint();
        EventQueue.invokeAndWait(
                () -> {
                    assertEquals(ExercisePanes.Room.RESULT.ordinal(), room());
                    Component giveUp = named(panel, "result.cancel");
                    assertTrue(giveUp.isVisible());
                    assertTrue(giveUp.getWidth() > 0, "has no place");
                    ((JButton) giveUp).doClick();
                    assertFalse(model.state().work().running());
                    assertFalse(giveUp.isVisible(), "nothing runs");
                    assertEquals("cancelled.sending", model.state().notice().key());
                });
    }

    @Test
    @DisplayName("two buttons give up the same work in a window that shows all")
    void oneButtonGivesUpWhereAllIsInSight() throws Exception {
        EventQueue.invokeAndWait(() -> model.enrolment().join(mute.address(), "CODE", "Ann"));
        for (int round = 0; round < 2; round++) OffscreenPainter.paint(panel, 2400, 1300);
        EventQueue.invokeAndWait(() -> assertFalse(named(panel, "result.cancel").isVisible()));
    }
}
