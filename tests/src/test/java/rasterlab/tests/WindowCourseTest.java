package rasterlab.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.event.KeyEvent;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.shell.LabTheme;
import rasterlab.tests.grading.GraderClient;
import rasterlab.tests.grading.ServerProcess;
import rasterlab.tests.grading.Solutions;

/** The tab of exercises and a course's server, under a real display. */
@Timeout(120)
class WindowCourseTest extends ExercisesHarness {
    @Test
    void serverThatIsDownIsToldAndNothingIsLost() {
        type("class A {}");
        join("http://127.0.0.1:1", "CODE");
        await("it is told", () -> noticed("no answer"));
        await("the keyboard is back where it was asked for", () -> hasKeyboard("server"));
        assertEquals("class A {}", window.textBox("source").text());
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(LabTheme.DARK)));
        robot.waitForIdle();
        window.button("server").click();
        JOptionPaneFixture again = window.optionPane();
        assertEquals("http://127.0.0.1:1", again.textBox("join.address").text());
        assertEquals("CODE", again.textBox("join.code").text());
        assertEquals("Ada", again.textBox("join.name").text());
        again.textBox("join.name").pressAndReleaseKeys(KeyEvent.VK_ESCAPE);
    }

    @Test
    void courseIsJoinedWhenAllIsTyped() {
        window.button("server").click();
        JOptionPaneFixture form = window.optionPane();
        var code = form.textBox("join.code").target();
        await("the first empty field has the keyboard", code::isFocusOwner);
        form.textBox("join.code").setText("CODE");
        assertFalse(form.button("join.ok").isEnabled());
        form.textBox("join.name").setText(" ");
        assertFalse(form.button("join.ok").isEnabled());
        form.textBox("join.name").setText("Ada");
        assertTrue(form.button("join.ok").isEnabled());
        form.checkBox("join.known").pressAndReleaseKeys(KeyEvent.VK_SPACE);
        form.checkBox("join.known").requireSelected();
        assertFalse(form.button("join.ok").isEnabled());
        form.textBox("join.token").pressAndReleaseKeys(KeyEvent.VK_ESCAPE);
    }

    @Test
    void submissionIsFollowedToItsResult() throws Exception {
        try (var server = ServerProcess.start(folder.resolve("course"))) {
            String code =
                    GraderClient.of(server.address(), server.token())
                            .post("/courses", "{\"name\":\"Computer graphics\"}")
                            .path("code")
                            .asText();
            type(Solutions.source(Solutions.WRONG));
            join(server.address().toString(), code);
            await("joined", () -> noticed("Submissions now go to"));
            window.button("submit").click();
            await("the verdict", () -> window.label("result.verdict").text().contains("wrong"));
            robot.waitForIdle();
            assertTrue(window.textBox("reason").text().contains("(4, 3)"));
            assertTrue(window.button("open").isEnabled());
        }
    }

    /**
     * Answers by the keyboard: where no window manager places dialogs, AWT now and then takes one
     * to be in the screen's corner, and a mouse that goes by that misses its buttons.
     */
    private void join(String address, String code) {
        window.button("server").click();
        JOptionPaneFixture form = window.optionPane();
        form.textBox("join.address").setText(address);
        form.textBox("join.code").setText(code);
        form.textBox("join.name").setText("Ada");
        form.textBox("join.name").pressAndReleaseKeys(KeyEvent.VK_ENTER);
    }

    private boolean noticed(String words) {
        return !window.robot()
                .finder()
                .findAll(
                        frame,
                        found ->
                                "notice".equals(found.getName())
                                        && found.isShowing()
                                        && found instanceof javax.swing.JTextArea area
                                        && area.getText().contains(words))
                .isEmpty();
    }
}
