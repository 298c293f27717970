package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Point;
import java.util.Optional;
import javax.swing.AbstractButton;
import javax.swing.JLabel;
import javax.swing.text.JTextComponent;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.Test;
import rasterlab.app.light.LightFrame;
import rasterlab.app.light.LitPlans;
import rasterlab.app.light.panel.LightRoom;
import rasterlab.app.plan.least.PlannedPicture;
import rasterlab.app.spline.SplineRoom;
import rasterlab.app.visibility.Picture;
import rasterlab.app.visibility.VisibilityRoom;

/** The least model that is enough, in the labs' windows under a real display. */
class WindowPlanTest extends WindowHarness {
    private Component named(String name) {
        return window.robot().finder().findByName(frame, name);
    }

    private String rowText(String label) {
        return GuiActionRunner.execute(() -> ((JLabel) named(label)).getText());
    }

    /** A box may be below what is seen of the inspector, where no mouse gets. */
    private void check(String box) {
        GuiActionRunner.execute(() -> ((AbstractButton) named(box)).doClick());
        robot.waitForIdle();
    }

    private void slide(String slider, int notch) {
        GuiActionRunner.execute(() -> window.slider(slider).target().setValue(notch));
        robot.waitForIdle();
    }

    private Optional<PlannedPicture> planned() {
        return GuiActionRunner.execute(
                () -> models.of(new VisibilityRoom()).state().picture().flatMap(Picture::planned));
    }

    private void showTorus() {
        show("visibility");
        window.comboBox("scene").selectItem("torus");
        check("least");
        await("the least picture", () -> planned().isPresent());
    }

    @Test
    void hiddenSurfacesAreDrawnByThePlanThatTheBillTells() {
        showTorus();
        await("both are measured", () -> !rowText("least.timed.value").equals("–"));
        for (String row : new String[] {"error", "measured", "time", "timed", "kept"})
            assertTrue(
                    rowText("least." + row + ".value").matches(".*[0-9].*"),
                    row + ": " + rowText("least." + row + ".value"));
        String decisions =
                GuiActionRunner.execute(
                        () -> ((JTextComponent) named("least.decisions")).getText());
        assertTrue(decisions.contains("visibility: pipeline, fronts only"), decisions);
        check("least");
        await("the method's picture is back", () -> planned().isEmpty());
        assertFalse(isSeen("least.timed.value"));
    }

    @Test
    void toleranceThatIsSlidIsThePlans() {
        showTorus();
        slide("least.levels", 16);
        await("8 levels", () -> levels() == 8);
        assertEquals("8", rowText("least.levels.value"));
        slide("least.levels", 0);
        await("0 levels", () -> levels() == 0);
        window.button("undo").click();
        await("what was before is back", () -> levels() == 8);
    }

    private double levels() {
        return planned().map(picture -> picture.plan().tolerance().levels()).orElse(-1.0);
    }

    @Test
    void dragKeepsThePlanAndADifferenceIsShownMagnified() {
        showTorus();
        PlannedPicture before = planned().orElseThrow();
        Component stage = named("stage");
        var middle = new Point(stage.getWidth() / 2, stage.getHeight() / 2);
        robot.pressMouse(stage, middle, MouseButton.LEFT_BUTTON);
        robot.moveMouse(stage, middle.x + 5, middle.y);
        robot.moveMouse(stage, middle.x + 6, middle.y);
        robot.releaseMouseButtons();
        robot.waitForIdle();
        await("another view", () -> !planned().orElseThrow().camera().equals(before.camera()));
        assertEquals(before.plan(), planned().orElseThrow().plan());
        int colored = colors("stage").size();
        check("least.magnified");
        await("the difference on black", () -> colors("stage").contains(0xFF000000));
        assertNotEquals(colored, colors("stage").size());
    }

    @Test
    void lightingShowsTheLeastLightBesideTheFullOne() {
        show("light");
        check("least");
        await("the least light", () -> lit().isPresent());
        await("both are measured", () -> !rowText("least.timed.value").equals("–"));
        slide("least.levels", 32);
        await("16 levels", () -> lit().orElseThrow().picture().plan().tolerance().levels() == 16);
        check("least");
        await("the three shadings are back", () -> lit().isEmpty());
        assertFalse(isSeen("least.timed.value"));
    }

    private Optional<LitPlans.ComparedPictures> lit() {
        return GuiActionRunner.execute(
                () ->
                        models.of(new LightRoom())
                                .state()
                                .drawn()
                                .flatMap(LightFrame.DrawnFrame::least));
    }

    @Test
    void splinesPlanPicksTheMethodForHowOftenACurveIsDrawn() {
        show("spline");
        check("planned");
        slide("times", 0);
        await("uniform for one drawing", () -> method().equals("uniform"));
        slide("times", 100);
        await("fewest for ten thousand", () -> method().equals("fewest"));
        assertTrue(rowText("picked.value").contains("fewest"), rowText("picked.value"));
        window.comboBox("method").selectItem("adaptive");
        await("the method chosen by hand", () -> method().equals("adaptive"));
        assertFalse(window.checkBox("planned").target().isSelected());
    }

    private String method() {
        return GuiActionRunner.execute(
                () -> models.of(new SplineRoom()).curve().state().drawing().method());
    }
}
