package rasterlab.app.coordinates.stack;

import java.util.ArrayList;
import java.util.List;
import org.joml.Vector3d;
import rasterlab.engine.transform.MatrixMode;
import rasterlab.engine.transform.MatrixStack;

/**
 * One line of a program.
 *
 * @param numbers as many as the command has
 */
public record StackCommand(StackOp op, List<Double> numbers) {
    public StackCommand {
        numbers = List.copyOf(numbers);
        if (numbers.size() != op.names().size())
            throw new IllegalArgumentException(
                    op.call() + " takes " + op.names().size() + " numbers, got " + numbers.size());
    }

    static StackCommand of(StackOp op, double... numbers) {
        var list = new ArrayList<Double>();
        for (double number : numbers) list.add(number);
        return new StackCommand(op, list);
    }

    static StackCommand first(StackOp op) {
        return new StackCommand(op, op.first());
    }

    StackCommand with(int index, double value) {
        var changed = new ArrayList<>(numbers);
        changed.set(index, value);
        return new StackCommand(op, changed);
    }

    private double number(int index) {
        return numbers.get(index);
    }

    private Vector3d vector(int from) {
        return new Vector3d(number(from), number(from + 1), number(from + 2));
    }

    private double[] all() {
        return numbers.stream().mapToDouble(Double::doubleValue).toArray();
    }

    /**
     * Does it; drawing does nothing to a stack.
     *
     * @throws IllegalStateException on overflow and underflow; nothing changes
     * @throws IllegalArgumentException if a number is not allowed; nothing changes
     */
    void run(MatrixStack stack) {
        switch (op) {
            case MODELVIEW, PROJECTION, TEXTURE -> stack.mode(MatrixMode.valueOf(op.name()));
            case PUSH -> stack.push();
            case POP -> stack.pop();
            case IDENTITY -> stack.loadIdentity();
            case TRANSLATE -> stack.translate(number(0), number(1), number(2));
            case ROTATE -> stack.rotate(number(0), number(1), number(2), number(3));
            case SCALE -> stack.scale(number(0), number(1), number(2));
            case LOOK_AT -> stack.lookAt(vector(0), vector(3), vector(6));
            case LOAD -> stack.loadMatrix(all());
            case MULT -> stack.multMatrix(all());
            case CUBE -> {}
            default -> project(stack);
        }
    }

    private void project(MatrixStack stack) {
        switch (op) {
            case ORTHO ->
                    stack.ortho(number(0), number(1), number(2), number(3), number(4), number(5));
            case ORTHO_2D -> stack.ortho2D(number(0), number(1), number(2), number(3));
            case FRUSTUM ->
                    stack.frustum(number(0), number(1), number(2), number(3), number(4), number(5));
            case PERSPECTIVE -> stack.perspective(number(0), number(1), number(2), number(3));
            default -> throw new AssertionError(op);
        }
    }
}
