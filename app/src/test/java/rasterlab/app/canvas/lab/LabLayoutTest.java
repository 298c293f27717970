package rasterlab.app.canvas.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.UsualLook;
import rasterlab.app.shell.settings.LabTheme;

/** A lab's inspector; that all labs of a window hide theirs at once takes a window. */
class LabLayoutTest {

    @AfterEach
    void inspectorsAreShownAgain() throws Exception {
        EventQueue.invokeAndWait(UsualLook::install);
    }

    private static LabLayout lab() {
        return new LabLayout(
                new JLabel("chips"),
                new JLabel("stage"),
                new Inspector(Texts.of("line", Language.ENGLISH)),
                new JPanel(),
                new JLabel("timeline"));
    }

    /** Does what the key does anywhere in the window. */
    private static void press(int key, LabLayout lab) {
        for (InspectorSwitch each : found(lab, InspectorSwitch.class)) {
            Object bound =
                    each.getInputMap(JComponent.WHEN_IN_FOCUSED_WINDOW)
                            .get(KeyStroke.getKeyStroke(key, 0));
            if (bound != null)
                each.getActionMap()
                        .get(bound)
                        .actionPerformed(new ActionEvent(each, ActionEvent.ACTION_PERFORMED, ""));
        }
    }

    private static <C extends Component> List<C> found(Container within, Class<C> kind) {
        var found = new ArrayList<C>();
        for (Component each : within.getComponents()) {
            if (kind.isInstance(each)) found.add(kind.cast(each));
            if (each instanceof Container inner) found.addAll(found(inner, kind));
        }
        return found;
    }

    /** Whether the inspector and everything around it is visible. */
    private static boolean shown(LabLayout lab) {
        Component inspector = found(lab, Inspector.class).get(0);
        for (Component each = inspector; each != lab; each = each.getParent())
            if (!each.isVisible()) return false;
        return true;
    }

    @Test
    void f9HidesTheInspectorAndBringsItBack() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabLayout lab = lab();
                    assertTrue(shown(lab));
                    press(KeyEvent.VK_F9, lab);
                    assertFalse(shown(lab));
                    press(KeyEvent.VK_F9, lab);
                    assertTrue(shown(lab));
                });
    }

    @ParameterizedTest(name = "parts of the lab stand beside each other, controls hidden: {0}")
    @ValueSource(booleans = {false, true})
    void stageStandsBetweenChipsAndTimeline(boolean hidden) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabLayout lab = lab();
                    if (hidden) press(KeyEvent.VK_F9, lab);
                    lab.setSize(900, 600);
                    lab.doLayout();
                    lab.guide().doLayout();
                    List<Rectangle> places =
                            found(lab, JLabel.class).stream()
                                    .filter(each -> isPart(each, lab))
                                    .map(each -> placeIn(lab, each))
                                    .toList();
                    assertEquals(3, places.size());
                    Rectangle stage = places.get(1);
                    assertTrue(stage.width > (hidden ? 800 : 400), places.toString());
                    for (Rectangle each : places) assertEquals(stage.x, each.x, places.toString());
                    assertTrue(places.get(0).getMaxY() <= stage.y, places.toString());
                    assertTrue(stage.getMaxY() <= places.get(2).y, places.toString());
                });
    }

    @ParameterizedTest(name = "the projector''s picture is small beside the controls: {0} %")
    @ValueSource(ints = {150, 200})
    void largeTypeLeavesTheStageTheWidthUntilTheInspectorIsAskedFor(int percent) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.PROJECTOR.install(percent);
                    LabLayout lab = lab();
                    layOut(lab);
                    assertFalse(shown(lab), "it crowds the stage");
                    assertTrue(stage(lab).getWidth() > 1100, stage(lab).getBounds().toString());
                    press(KeyEvent.VK_F9, lab);
                    layOut(lab);
                    assertTrue(shown(lab), "it was asked for");
                    press(KeyEvent.VK_F9, lab);
                    layOut(lab);
                    assertFalse(shown(lab), "it was sent away");
                    assertTrue(LabLayout.showsInspectors(), "in other type it is seen again");
                });
    }

    @ParameterizedTest(name = "the controls are gone though they have room: {0}")
    @EnumSource(LabTheme.class)
    void inspectorThatHasRoomIsSeen(LabTheme theme) throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    theme.install();
                    LabLayout lab = lab();
                    layOut(lab);
                    assertTrue(shown(lab));
                });
    }

    private static void layOut(LabLayout lab) {
        lab.setSize(1280, 740);
        lab.doLayout();
        lab.doLayout();
        lab.guide().doLayout();
    }

    /** Whether it is one of those that the layout was given. */
    private static boolean isPart(Component each, LabLayout lab) {
        return each.getParent() == lab || each.getParent() == lab.guide();
    }

    private static Rectangle placeIn(LabLayout lab, Component part) {
        return SwingUtilities.convertRectangle(part.getParent(), part.getBounds(), lab);
    }

    private static Component stage(LabLayout lab) {
        return found(lab, JLabel.class).stream()
                .filter(each -> each.getText().equals("stage"))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void labThatIsMadeLaterHidesItsInspectorToo() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    press(KeyEvent.VK_F9, lab());
                    assertFalse(shown(lab()));
                });
    }

    @Test
    void switchSaysWhatItDoesNext() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    LabLayout lab = lab();
                    InspectorSwitch hides = found(lab, InspectorSwitch.class).get(0);
                    String before = hides.getToolTipText();
                    hides.doClick();
                    assertNotEquals(before, hides.getToolTipText());
                });
    }
}
