package rasterlab.tests.window;

import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.BeforeEach;

/** A window that shows the tab of exercises. */
abstract class ExercisesHarness extends WindowHarness {
    @BeforeEach
    void showExercises() {
        if (window != null) show("exercises");
    }

    void type(String source) {
        GuiActionRunner.execute(() -> models.exercises().type(source));
        robot.waitForIdle();
    }

    /**
     * Whether the button has the keyboard, or will have it when the window has: not every display
     * gives it back after a dialog.
     */
    boolean hasKeyboard(String button) {
        var target = window.button(button).target();
        return GuiActionRunner.execute(() -> frame.getMostRecentFocusOwner() == target);
    }
}
