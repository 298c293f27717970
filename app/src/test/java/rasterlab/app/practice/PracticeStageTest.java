package rasterlab.app.practice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.practice.Board.BoardCell;
import rasterlab.app.practice.Board.BoardDot;
import rasterlab.app.practice.Board.BoardSpace;
import rasterlab.app.practice.Board.FigureLook;
import rasterlab.app.practice.Board.NoPick;
import rasterlab.app.practice.Board.PixelPick;

/** Zoom of the picture of a question, and what is clicked in it then. */
class PracticeStageTest {
    private static final Point HERE = new Point(300, 200);
    private static final Point THERE = new Point(520, 330);

    private final List<ObjectNode> picked = new ArrayList<>();
    private final PracticeStage stage =
            new PracticeStage(
                    Texts.of("practice", Language.ENGLISH), pick -> picked.add(pick.answer()));
    private final Board pixels =
            new Board(
                    BoardSpace.PIXELS,
                    List.of(
                            new BoardCell(0, 0, FigureLook.NEWEST),
                            new BoardCell(30, 20, FigureLook.DONE)),
                    new PixelPick("x", "y"));

    @BeforeEach
    void show() {
        stage.setSize(800, 560);
        stage.doLayout();
        stage.show(pixels, true, true);
    }

    private void mouse(int kind, Point at, int button, int clicks) {
        int mask =
                button == MouseEvent.BUTTON1
                        ? InputEvent.BUTTON1_DOWN_MASK
                        : InputEvent.BUTTON3_DOWN_MASK;
        stage.dispatchEvent(
                new MouseEvent(stage, kind, 0, mask, at.x, at.y, clicks, false, button));
    }

    private ObjectNode click(Point at) {
        mouse(MouseEvent.MOUSE_PRESSED, at, MouseEvent.BUTTON1, 1);
        mouse(MouseEvent.MOUSE_RELEASED, at, MouseEvent.BUTTON1, 1);
        return picked.get(picked.size() - 1);
    }

    private void wheel(Point at, int notches) {
        stage.dispatchEvent(
                new MouseWheelEvent(
                        stage,
                        MouseEvent.MOUSE_WHEEL,
                        0,
                        0,
                        at.x,
                        at.y,
                        0,
                        false,
                        MouseWheelEvent.WHEEL_UNIT_SCROLL,
                        1,
                        notches));
    }

    private static void press(PracticeStage stage, char key) {
        SwingUtilities.processKeyBindings(
                new KeyEvent(stage, KeyEvent.KEY_TYPED, 0, 0, KeyEvent.VK_UNDEFINED, key));
    }

    @Test
    void wheelBringsNearerWhatIsUnderThePointer() {
        ObjectNode here = click(HERE);
        ObjectNode there = click(THERE);
        wheel(HERE, -3);
        assertEquals(here, click(HERE), "the pixel under the pointer stays there");
        int before = there.get("x").intValue() - here.get("x").intValue();
        int now = click(THERE).get("x").intValue() - here.get("x").intValue();
        assertTrue(now > 0 && now < before, before + " pixels before, now " + now);
    }

    @Test
    void plusAndMinusZoomAndZeroShowsEverything() {
        ObjectNode there = click(THERE);
        press(stage, '+');
        ObjectNode nearer = click(THERE);
        assertNotEquals(there, nearer);
        press(stage, '-');
        assertEquals(there, click(THERE));
        press(stage, '+');
        press(stage, '0');
        assertEquals(there, click(THERE));
    }

    @Test
    void rightButtonMovesThePictureAndAnswersNothing() {
        ObjectNode here = click(HERE);
        mouse(MouseEvent.MOUSE_PRESSED, HERE, MouseEvent.BUTTON3, 1);
        mouse(MouseEvent.MOUSE_DRAGGED, THERE, MouseEvent.BUTTON3, 1);
        mouse(MouseEvent.MOUSE_RELEASED, THERE, MouseEvent.BUTTON3, 1);
        assertEquals(1, picked.size());
        assertEquals(here, click(THERE));
    }

    @Test
    void doubleClickThatAnswersNothingShowsEverything() {
        ObjectNode there = click(THERE);
        wheel(HERE, -3);
        mouse(MouseEvent.MOUSE_CLICKED, THERE, MouseEvent.BUTTON3, 2);
        assertEquals(there, click(THERE));
        wheel(HERE, -3);
        ObjectNode nearer = click(THERE);
        mouse(MouseEvent.MOUSE_CLICKED, THERE, MouseEvent.BUTTON1, 2);
        assertEquals(nearer, click(THERE), "both clicks were answers");
    }

    @Test
    void doubleClickInAPictureWithoutAnswersShowsEverything() {
        var plane =
                new Board(
                        BoardSpace.PLANE,
                        List.of(
                                new BoardDot(new Point2D.Double(), "", FigureLook.GIVEN),
                                new BoardDot(new Point2D.Double(4, 3), "", FigureLook.GIVEN)),
                        new NoPick());
        stage.show(plane, true, true);
        String before = pointed();
        wheel(HERE, -3);
        assertNotEquals(before, pointed());
        mouse(MouseEvent.MOUSE_CLICKED, THERE, MouseEvent.BUTTON1, 2);
        assertEquals(before, pointed());
    }

    /** The text of the read-out for a place. */
    private String pointed() {
        mouse(MouseEvent.MOUSE_MOVED, THERE, MouseEvent.NOBUTTON, 0);
        for (var each : stage.getComponents())
            if (each instanceof JLabel label) return label.getText();
        throw new AssertionError("no read-out");
    }

    @Test
    void anotherStepKeepsTheZoomAndOtherDataDoNot() {
        ObjectNode there = click(THERE);
        wheel(HERE, -3);
        ObjectNode nearer = click(THERE);
        stage.show(pixels, false, true);
        assertEquals(nearer, click(THERE));
        stage.show(pixels, true, true);
        assertEquals(there, click(THERE));
    }
}
