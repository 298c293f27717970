package rasterlab.app.coordinates.stack;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.joml.Matrix4d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.transform.MatrixMode;

class StackLabModelTest {
    private final StackLabModel model = new StackLabModel();

    private int depth(MatrixMode mode) {
        return model.scene().stacks().get(mode).size();
    }

    @Test
    @DisplayName("a full stack takes one more, or says nothing")
    void overflowIsTold() {
        model.show(StackProgram.OVERFLOW);
        assertEquals(2, depth(MatrixMode.PROJECTION));
        assertEquals(StackScene.StackErrorKind.OVERFLOW, model.scene().errors().get(4).kind());
        model.goTo(4);
        assertTrue(model.scene().errors().isEmpty());
    }

    @Test
    @DisplayName("the last matrix is taken away, or nothing is said")
    void underflowIsTold() {
        model.show(StackProgram.UNDERFLOW);
        assertEquals(1, depth(MatrixMode.MODELVIEW));
        assertEquals(StackScene.StackErrorKind.UNDERFLOW, model.scene().errors().get(5).kind());
        assertEquals(2, model.scene().cubes().size());
    }

    @Test
    @DisplayName("a number that is not allowed changes the matrix")
    void refusedNumbersAreTold() {
        for (StackProgram program : List.of(StackProgram.NO_AXIS, StackProgram.NO_WIDTH)) {
            model.show(program);
            assertTrue(
                    model.scene().errors().values().stream()
                            .allMatch(error -> error.kind() == StackScene.StackErrorKind.VALUE));
            assertEquals(1, model.scene().errors().size(), program.name());
            for (MatrixMode mode : MatrixMode.values())
                assertEquals(
                        new Matrix4d(), model.scene().stacks().get(mode).get(0), program.name());
        }
    }

    @Test
    @DisplayName("thirty-two matrices are not enough for MODELVIEW")
    void modelviewIsThirtyTwoDeep() {
        model.clear();
        for (int i = 0; i < 32; i++) model.add(StackOp.PUSH);
        assertEquals(32, depth(MatrixMode.MODELVIEW));
        assertEquals(List.of(31), List.copyOf(model.scene().errors().keySet()));
    }

    @Test
    @DisplayName("one link's thickness goes on to the next")
    void popTakesTheThicknessBack() {
        model.show(StackProgram.ARM);
        Matrix4d last = model.scene().cubes().get(2);
        assertEquals(4, length(last), 1e-12);
        model.show(StackProgram.FORGOTTEN_PUSH);
        assertTrue(length(model.scene().cubes().get(2)) > 20);
    }

    /** The length of the image of the x axis, which is the matrix's first row. */
    private static double length(Matrix4d matrix) {
        return Math.sqrt(
                matrix.m00() * matrix.m00()
                        + matrix.m01() * matrix.m01()
                        + matrix.m02() * matrix.m02());
    }

    @Test
    @DisplayName("a command is done behind the whole program")
    void newCommandsFollowTheOneThatIsDone() {
        model.goTo(1);
        model.add(StackOp.POP);
        assertEquals(2, model.step());
        assertEquals(StackOp.POP, model.choice().commands().get(1).op());
        assertEquals(StackOp.POP, model.newest().orElseThrow().op());
        model.remove();
        assertEquals(1, model.step());
        assertEquals(StackOp.PUSH, model.choice().commands().get(1).op());
    }

    @Test
    @DisplayName("another command's numbers are changed")
    void editsTheNewestCommand() {
        model.goTo(1);
        model.set(0, 90);
        assertEquals(90, model.choice().commands().get(0).numbers().get(0));
        model.history().undo();
        assertEquals(25, model.choice().commands().get(0).numbers().get(0));
        model.goTo(0);
        model.set(0, 90);
        model.remove();
        assertEquals(StackProgram.ARM.commands(), model.choice().commands());
    }

    @Test
    @DisplayName("a command of the chooser is refused as it is added")
    void everyCommandIsAddedWithNumbersThatAreAllowed() {
        for (StackOp op : StackOp.values()) {
            if (op == StackOp.POP) continue;
            model.clear();
            model.add(op);
            assertEquals(1, model.step());
            assertTrue(model.scene().errors().isEmpty(), op.name());
        }
    }

    @Test
    @DisplayName("a program grows without end")
    void programsHaveAnEnd() {
        for (int i = 0; i < 120; i++) model.add(StackOp.CUBE);
        assertEquals(StackChoice.MOST, model.choice().commands().size());
    }
}
