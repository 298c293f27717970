package rasterlab.engine.transform;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import org.joml.Matrix4d;
import org.joml.Vector3d;

/**
 * OpenGL's three stacks of matrices and the commands that change the one on top.
 *
 * <p>A command multiplies the current matrix so that what it does happens to a point before what
 * the earlier commands do. A list of commands can be read in two ways: backwards, as motions of the
 * objects in fixed axes, or forwards, as motions of the axes in which the objects are given.
 *
 * <p>Every command throws an IllegalArgumentException and changes nothing where an argument is not
 * finite or a cell of the product would not be.
 *
 * <p>Source: M. Segal, K. Akeley, The OpenGL Graphics System: A Specification, version 1.5, 2003,
 * section 2.11.
 */
public final class MatrixStack {
    private static final String SIDES = "left right bottom top near far";

    private final Map<MatrixMode, Deque<Matrix4d>> stacks = new EnumMap<>(MatrixMode.class);
    private MatrixMode mode = MatrixMode.MODELVIEW;

    /** Each stack holds one identity; the mode is MODELVIEW. */
    public MatrixStack() {
        for (MatrixMode each : MatrixMode.values()) {
            var stack = new ArrayDeque<Matrix4d>();
            stack.push(new Matrix4d());
            stacks.put(each, stack);
        }
    }

    /** Chooses the stack that all other commands mean. */
    public void mode(MatrixMode chosen) {
        mode = chosen;
    }

    /** A copy of the matrix on top of a stack. */
    public Matrix4d top(MatrixMode of) {
        return new Matrix4d(stacks.get(of).element());
    }

    /** Copies of all matrices of a stack, the one on top first. */
    public List<Matrix4d> matrices(MatrixMode of) {
        return stacks.get(of).stream().map(Matrix4d::new).toList();
    }

    /**
     * @throws IllegalStateException if the stack is full; nothing changes
     */
    public void push() {
        if (stack().size() == mode.depth())
            throw new IllegalStateException(
                    "GL_STACK_OVERFLOW: the %s stack holds at most %d matrices"
                            .formatted(mode, mode.depth()));
        stack().push(new Matrix4d(current()));
    }

    /**
     * @throws IllegalStateException if there is only one matrix; nothing changes
     */
    public void pop() {
        if (stack().size() == 1)
            throw new IllegalStateException(
                    "GL_STACK_UNDERFLOW: the %s stack holds its last matrix".formatted(mode));
        stack().pop();
    }

    public void loadIdentity() {
        current().identity();
    }

    /**
     * @param columns 16 numbers column by column as OpenGL multiplies, {@code M · v}; that is row
     *     by row in the textbook's layout
     */
    public void loadMatrix(double... columns) {
        current().set(checked(columns));
    }

    /** Multiplies by a matrix given as for {@link #loadMatrix}. */
    public void multMatrix(double... columns) {
        multiply(new Matrix4d().set(checked(columns)));
    }

    public void translate(double x, double y, double z) {
        requireFinite("x y z", x, y, z);
        multiply(TextbookMatrices.translation(x, y, z));
    }

    public void scale(double x, double y, double z) {
        requireFinite("x y z", x, y, z);
        multiply(TextbookMatrices.scale(x, y, z));
    }

    /**
     * Turns counter-clockwise about the direction (x, y, z) through the origin.
     *
     * @throws IllegalArgumentException if the direction is zero
     */
    public void rotate(double degrees, double x, double y, double z) {
        requireFinite("degrees x y z", degrees, x, y, z);
        if (x == 0 && y == 0 && z == 0)
            throw new IllegalArgumentException("the axis must not be zero, got (0, 0, 0)");
        multiply(
                TextbookMatrices.rotationAbout(
                        new Vector3d(),
                        Directions.unit(new Vector3d(x, y, z)),
                        Angle.ofDegrees(degrees)));
    }

    public void lookAt(Vector3d eye, Vector3d center, Vector3d up) {
        requireFinite("eye.x eye.y eye.z", eye.x, eye.y, eye.z);
        requireFinite("center.x center.y center.z", center.x, center.y, center.z);
        requireFinite("up.x up.y up.z", up.x, up.y, up.z);
        multiply(ViewMatrices.lookAt(eye, center, up));
    }

    public void ortho(
            double left, double right, double bottom, double top, double near, double far) {
        requireFinite(SIDES, left, right, bottom, top, near, far);
        multiply(GlMatrices.ortho(left, right, bottom, top, near, far));
    }

    /** {@link #ortho} with near −1 and far 1. */
    public void ortho2D(double left, double right, double bottom, double top) {
        ortho(left, right, bottom, top, -1, 1);
    }

    public void frustum(
            double left, double right, double bottom, double top, double near, double far) {
        requireFinite(SIDES, left, right, bottom, top, near, far);
        multiply(GlMatrices.frustum(left, right, bottom, top, near, far));
    }

    public void perspective(double fovy, double aspect, double near, double far) {
        requireFinite("fovy aspect near far", fovy, aspect, near, far);
        multiply(GlMatrices.perspective(fovy, aspect, near, far));
    }

    private void multiply(Matrix4d matrix) {
        Matrix4d product = current().mul(matrix, new Matrix4d());
        double[] cells = product.get(new double[16]);
        for (int i = 0; i < 16; i++)
            if (!Double.isFinite(cells[i]))
                throw new IllegalArgumentException(
                        "row %d, column %d of the product is too large for a double; the current matrix stays"
                                .formatted(i / 4 + 1, i % 4 + 1));
        current().set(product);
    }

    private static void requireFinite(String names, double... values) {
        for (int i = 0; i < values.length; i++)
            if (!Double.isFinite(values[i]))
                throw new IllegalArgumentException(
                        "%s must be a finite number, got %s"
                                .formatted(names.split(" ")[i], values[i]));
    }

    private static double[] checked(double[] columns) {
        if (columns.length != 16)
            throw new IllegalArgumentException("a matrix has 16 numbers, got " + columns.length);
        for (int i = 0; i < 16; i++)
            if (!Double.isFinite(columns[i]))
                throw new IllegalArgumentException(
                        "number %d of the matrix must be finite, got %s".formatted(i, columns[i]));
        return columns;
    }

    private Matrix4d current() {
        return stack().element();
    }

    private Deque<Matrix4d> stack() {
        return stacks.get(mode);
    }
}
