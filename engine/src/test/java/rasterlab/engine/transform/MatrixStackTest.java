package rasterlab.engine.transform;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.joml.Matrix4d;
import org.joml.Vector3d;
import org.joml.Vector4d;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

class MatrixStackTest {
    private final MatrixStack stack = new MatrixStack();

    @ParameterizedTest(name = "{0} grows without end")
    @EnumSource(MatrixMode.class)
    void overflowIsAnErrorThatChangesNothing(MatrixMode mode) {
        assertTrue(mode.depth() >= (mode == MatrixMode.MODELVIEW ? 32 : 2));
        stack.mode(mode);
        for (int depth = 1; depth < mode.depth(); depth++) stack.push();
        var error = assertThrows(IllegalStateException.class, stack::push);
        assertEquals(
                "GL_STACK_OVERFLOW: the %s stack holds at most %d matrices"
                        .formatted(mode, mode.depth()),
                error.getMessage());
        assertEquals(mode.depth(), stack.matrices(mode).size());
    }

    @ParameterizedTest(name = "{0} loses its last matrix")
    @EnumSource(MatrixMode.class)
    void underflowIsAnErrorThatChangesNothing(MatrixMode mode) {
        stack.mode(mode);
        stack.scale(2, 2, 2);
        var error = assertThrows(IllegalStateException.class, stack::pop);
        assertEquals(
                "GL_STACK_UNDERFLOW: the %s stack holds its last matrix".formatted(mode),
                error.getMessage());
        assertEquals(2, stack.top(mode).m00());
    }

    @Test
    @DisplayName("matrices are listed from below, or shared with the stack")
    void listsCopiesFromTheTopDown() {
        stack.translate(1, 2, 3);
        stack.push();
        stack.scale(2, 2, 2);
        List<Matrix4d> listed = stack.matrices(MatrixMode.MODELVIEW);
        assertEquals(2, listed.size());
        assertEquals(stack.top(MatrixMode.MODELVIEW), listed.get(0));
        assertEquals(1, listed.get(1).m00());
        listed.get(0).identity();
        assertEquals(2, stack.top(MatrixMode.MODELVIEW).m00());
    }

    @Test
    @DisplayName("a pushed matrix is shared with the one below")
    void popBringsBackWhatWasPushed() {
        stack.translate(1, 2, 3);
        Matrix4d before = stack.top(MatrixMode.MODELVIEW);
        stack.push();
        stack.rotate(90, 0, 0, 1);
        stack.loadIdentity();
        stack.pop();
        assertEquals(before, stack.top(MatrixMode.MODELVIEW));
    }

    @Test
    @DisplayName("who asks for the top holds the stack's own matrix")
    void topIsACopy() {
        stack.top(MatrixMode.MODELVIEW).translate(1, 2, 3);
        assertEquals(new Matrix4d(), stack.top(MatrixMode.MODELVIEW));
    }

    @Test
    @DisplayName("all modes change one matrix")
    void modesHaveStacksOfTheirOwn() {
        stack.mode(MatrixMode.PROJECTION);
        stack.ortho2D(0, 8, 0, 6);
        stack.push();
        assertEquals(new Matrix4d(), stack.top(MatrixMode.MODELVIEW));
        assertEquals(new Matrix4d(), stack.top(MatrixMode.TEXTURE));
        assertEquals(1, stack.matrices(MatrixMode.TEXTURE).size());
        assertEquals(2, stack.matrices(MatrixMode.PROJECTION).size());
    }

    @Test
    @DisplayName("the matrix is loaded row by row")
    void loadMatrixReadsColumnByColumn() {
        stack.loadMatrix(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1);
        assertEquals(new Vector4d(7, 8, 9, 1), image(0, 0, 0));
        stack.multMatrix(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
        assertEquals(new Vector4d(7, 9, 9, 1), image(1, 0, 0));
    }

    @Test
    @DisplayName("a NaN or half a matrix is loaded")
    void refusesWhatIsNoMatrix() {
        var few = assertThrows(IllegalArgumentException.class, () -> stack.loadMatrix(1, 2, 3));
        assertEquals("a matrix has 16 numbers, got 3", few.getMessage());
        var cells = new double[16];
        cells[5] = Double.NaN;
        var nan = assertThrows(IllegalArgumentException.class, () -> stack.multMatrix(cells));
        assertEquals("number 5 of the matrix must be finite, got NaN", nan.getMessage());
        var axis = assertThrows(IllegalArgumentException.class, () -> stack.rotate(1, 0, 0, 0));
        assertEquals("the axis must not be zero, got (0, 0, 0)", axis.getMessage());
        assertEquals(new Matrix4d(), stack.top(MatrixMode.MODELVIEW));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("notFinite")
    void namesTheArgumentThatIsNotFinite(Consumer<MatrixStack> command, String message) {
        var refusal = assertThrows(IllegalArgumentException.class, () -> command.accept(stack));
        assertEquals(message, refusal.getMessage());
        assertEquals(new Matrix4d(), stack.top(MatrixMode.MODELVIEW));
    }

    static Stream<Arguments> notFinite() {
        double nan = Double.NaN;
        var o = new Vector3d();
        var up = new Vector3d(0, 1, 0);
        return Stream.of(
                mistake("translate takes NaN", s -> s.translate(nan, 0, 0), "x", nan),
                mistake("scale takes infinity", s -> s.scale(1, 1, 1 / 0.0), "z", 1 / 0.0),
                mistake("rotate names a cell", s -> s.rotate(90, 0, nan, 1), "y", nan),
                mistake("rotate takes a NaN angle", s -> s.rotate(nan, 0, 0, 1), "degrees", nan),
                mistake("frustum names a cell", s -> s.frustum(0, 1, 0, nan, 1, 2), "top", nan),
                mistake("ortho names a cell", s -> s.ortho(nan, 1, 0, 1, 1, 2), "left", nan),
                mistake("no fovy is taken", s -> s.perspective(nan, 1, 1, 2), "fovy", nan),
                mistake(
                        "lookAt names a cell",
                        s -> s.lookAt(o, new Vector3d(0, nan, 0), up),
                        "center.y",
                        nan));
    }

    private static Arguments mistake(
            String mistake, Consumer<MatrixStack> command, String place, double value) {
        return argumentSet(mistake, command, place + " must be a finite number, got " + value);
    }

    @Test
    @DisplayName("factors that are finite leave infinity on the stack")
    void checksTheProductAndChangesNothing() {
        stack.scale(1e200, 1, 1);
        Matrix4d before = stack.top(MatrixMode.MODELVIEW);
        String message =
                "row 1, column 1 of the product is too large for a double; the current matrix stays";
        double[] huge = {1e200, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        for (Executable command :
                List.<Executable>of(() -> stack.scale(1e200, 1, 1), () -> stack.multMatrix(huge))) {
            var refusal = assertThrows(IllegalArgumentException.class, command);
            assertEquals(message, refusal.getMessage());
            assertEquals(before, stack.top(MatrixMode.MODELVIEW));
        }
    }

    @Test
    @DisplayName("rotate turns clockwise or in radians")
    void rotateIsCounterClockwiseInDegrees() {
        stack.rotate(90, 0, 0, 5);
        assertEquals(new Vector4d(0, 1, 0, 1), image(1, 0, 0));
    }

    /** Translate, turn about y, turn about x: chapter 14's DrawScene with its 260. */
    @Test
    void chapter14ObjectsMoveWhenTheListIsReadBackwards() {
        stack.translate(0, 0, -260);
        stack.rotate(30, 0, 1, 0);
        stack.rotate(50, 1, 0, 0);
        var moved = new Vector3d(1, 2, 3);
        moved.rotateX(Math.toRadians(50)).rotateY(Math.toRadians(30)).add(0, 0, -260);
        assertClose(moved, image(1, 2, 3));
    }

    /**
     * Each command moves the axes within the axes as they are by then: the list is read forwards.
     */
    @Test
    void chapter14AxesMoveWhenTheListIsReadForwards() {
        stack.translate(0, 0, -260);
        stack.rotate(30, 0, 1, 0);
        stack.rotate(50, 1, 0, 0);
        var origin = new Vector3d(0, 0, -260);
        var x = new Vector3d(1, 0, 0);
        var y = new Vector3d(0, 1, 0);
        var z = new Vector3d(0, 0, 1);
        double c = Math.cos(Math.toRadians(30));
        double s = Math.sin(Math.toRadians(30));
        var turnedX = new Vector3d(x).mul(c).sub(new Vector3d(z).mul(s));
        var turnedZ = new Vector3d(x).mul(s).add(new Vector3d(z).mul(c));
        c = Math.cos(Math.toRadians(50));
        s = Math.sin(Math.toRadians(50));
        var turnedY = new Vector3d(y).mul(c).add(new Vector3d(turnedZ).mul(s));
        turnedZ = new Vector3d(turnedZ).mul(c).sub(new Vector3d(y).mul(s));
        var seen = origin.add(turnedX.mul(1)).add(turnedY.mul(2)).add(turnedZ.mul(3));
        assertClose(seen, image(1, 2, 3));
    }

    @Test
    void matrixIsTheSameAsJomlsOwn() {
        stack.lookAt(new Vector3d(3, 4, 5), new Vector3d(1, 1, 0), new Vector3d(0, 0, 1));
        var joml = new Matrix4d().lookAt(3, 4, 5, 1, 1, 0, 0, 0, 1);
        assertTrue(joml.equals(stack.top(MatrixMode.MODELVIEW), 1e-14));
        stack.loadIdentity();
        stack.frustum(-1, 2, -3, 4, 5, 6);
        assertTrue(
                new Matrix4d()
                        .frustum(-1, 2, -3, 4, 5, 6)
                        .equals(stack.top(MatrixMode.MODELVIEW), 1e-14));
        stack.loadIdentity();
        stack.perspective(50, 1.5, 0.1, 100);
        assertTrue(
                new Matrix4d()
                        .perspective(Math.toRadians(50), 1.5, 0.1, 100)
                        .equals(stack.top(MatrixMode.MODELVIEW), 1e-14));
        stack.loadIdentity();
        stack.ortho(-1, 2, -3, 4, 5, 6);
        assertTrue(
                new Matrix4d()
                        .ortho(-1, 2, -3, 4, 5, 6)
                        .equals(stack.top(MatrixMode.MODELVIEW), 1e-14));
    }

    @Test
    @DisplayName("the window's origin is its top left corner")
    void viewportStartsAtTheBottomLeft() {
        Matrix4d window = GlMatrices.viewport(10, 20, 100, 50, 0, 1);
        assertEquals(new Vector3d(10, 20, 0), window.transformPosition(new Vector3d(-1, -1, -1)));
        assertEquals(new Vector3d(110, 70, 1), window.transformPosition(new Vector3d(1, 1, 1)));
        Matrix4d reversed = GlMatrices.viewport(0, 0, 2, 2, 1, 0);
        assertEquals(new Vector3d(1, 1, 0.5), reversed.transformPosition(new Vector3d()));
    }

    private Vector4d image(double x, double y, double z) {
        return new Vector4d(x, y, z, 1).mul(stack.top(MatrixMode.MODELVIEW));
    }

    private static void assertClose(Vector3d expected, Vector4d actual) {
        assertTrue(
                expected.distance(new Vector3d(actual.x, actual.y, actual.z)) < 1e-12,
                expected + " and " + actual);
    }
}
