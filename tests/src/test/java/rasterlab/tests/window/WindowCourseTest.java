package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.event.KeyEvent;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.fixture.JOptionPaneFixture;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.tests.grading.GraderClient;
import rasterlab.tests.grading.ServerProcess;
import rasterlab.tests.grading.Solutions;

/** The tab of exercises and a course's server, under a real display. */
@Timeout(300)
class WindowCourseTest extends ExercisesHarness {
    @Test
    void serverThatIsDownIsToldAndNothingIsLost() {
        type("class A {}");
        JOptionPaneFixture form = join("http://127.0.0.1:1", "CODE");
        await("it is told beside the address", () -> tells(form, "no answer"));
        var address = form.textBox("join.address").target();
        await("the address has the keyboard", address::isFocusOwner);
        assertEquals("CODE", form.textBox("join.code").text());
        form.textBox("join.address").pressAndReleaseKeys(KeyEvent.VK_ESCAPE);
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
    void formStaysForAWrongAddress() {
        JOptionPaneFixture form = join("not a server", "CODE");
        await("it is told beside the address", () -> tells(form, "is not a server’s address"));
        assertEquals("Ada", form.textBox("join.name").text());
        form.checkBox("join.known").pressAndReleaseKeys(KeyEvent.VK_SPACE);
        form.textBox("join.token").setText("secret");
        form.textBox("join.token").pressAndReleaseKeys(KeyEvent.VK_ENTER);
        await("it is told again", () -> tells(form, "is not a server’s address"));
        form.textBox("join.address").setText("http://127.0.0.1:1");
        form.textBox("join.address").pressAndReleaseKeys(KeyEvent.VK_ENTER);
        await("nobody knows the token", () -> tells(form, "no answer"));
        form.textBox("join.address").pressAndReleaseKeys(KeyEvent.VK_ESCAPE);
    }

    @Test
    void submissionToADeadServerLeavesTheKeyboardToTheButton() throws Exception {
        window.resizeTo(new Dimension(900, 600));
        showProgram();
        try (var server = ServerProcess.start(folder.resolve("course"))) {
            window.button("server").click();
            JOptionPaneFixture form = window.optionPane();
            form.checkBox("join.known").pressAndReleaseKeys(KeyEvent.VK_SPACE);
            form.textBox("join.address").setText(server.address().toString());
            form.textBox("join.token").setText("secret");
            form.textBox("join.token").pressAndReleaseKeys(KeyEvent.VK_ENTER);
            await("the token is refused", () -> tells(form, "does not know this token"));
            form.textBox("join.token").setText(server.token());
            form.textBox("join.token").pressAndReleaseKeys(KeyEvent.VK_ENTER);
            await("the token is taken", () -> noticed("Submissions now go to"));
        }
        window.button("submit").click();
        await("it is told", () -> noticed("no answer"));
        await("the keyboard is at the button", () -> hasKeyboard("submit"));
    }

    private void showProgram() {
        var rooms = window.tabbedPane("rooms");
        rooms.selectTab(1);
        await("the program is in sight", () -> window.button("server").target().isShowing());
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
            JOptionPaneFixture form = join(server.address().toString(), "WRONG");
            await("the code is refused", () -> tells(form, "no course with this code"));
            var field = form.textBox("join.code").target();
            await("the code has the keyboard", field::isFocusOwner);
            form.textBox("join.code").pressAndReleaseKeys(KeyEvent.VK_TAB);
            await("Tab goes on to the name", form.textBox("join.name").target()::isFocusOwner);
            int told = GuiActionRunner.execute(() -> form.textBox("join.problem").target().getY());
            assertTrue(told > field.getY(), "told above the code");
            assertTrue(told < form.textBox("join.name").target().getY(), "told below the name");
            form.textBox("join.code").setText(code);
            form.textBox("join.code").pressAndReleaseKeys(KeyEvent.VK_ENTER);
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
    private JOptionPaneFixture join(String address, String code) {
        window.button("server").click();
        JOptionPaneFixture form = window.optionPane();
        form.textBox("join.address").setText(address);
        form.textBox("join.code").setText(code);
        form.textBox("join.name").setText("Ada");
        form.textBox("join.name").pressAndReleaseKeys(KeyEvent.VK_ENTER);
        return form;
    }

    private static boolean tells(JOptionPaneFixture form, String words) {
        return form.textBox("join.problem").target().isShowing()
                && form.textBox("join.problem").text().contains(words);
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
