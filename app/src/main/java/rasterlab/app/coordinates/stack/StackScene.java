package rasterlab.app.coordinates.stack;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.joml.Matrix4d;
import rasterlab.engine.transform.MatrixMode;
import rasterlab.engine.transform.MatrixStack;

/**
 * The state that the first commands of a program leave behind.
 *
 * @param stacks every stack's matrices, the one on top first
 * @param mode the stack that the next command means
 * @param cubes MODELVIEW as each drawn cube found it
 * @param errors what a command said instead of doing anything, by its number from 0
 */
record StackScene(
        Map<MatrixMode, List<Matrix4d>> stacks,
        MatrixMode mode,
        List<Matrix4d> cubes,
        Map<Integer, Error> errors) {
    /**
     * @param kind overflow, underflow, or a number that is not allowed
     * @param message in the engine's words
     */
    record Error(StackErrorKind kind, String message) {}

    /** The error that a command ended with. */
    enum StackErrorKind {
        OVERFLOW,
        UNDERFLOW,
        VALUE
    }

    static StackScene of(List<StackCommand> commands, int step) {
        var stack = new MatrixStack();
        MatrixMode mode = MatrixMode.MODELVIEW;
        var cubes = new ArrayList<Matrix4d>();
        var errors = new TreeMap<Integer, Error>();
        for (int i = 0; i < step; i++) {
            StackCommand command = commands.get(i);
            if (command.op().ordinal() <= StackOp.TEXTURE.ordinal())
                mode = MatrixMode.valueOf(command.op().name());
            if (command.op() == StackOp.CUBE) cubes.add(stack.top(MatrixMode.MODELVIEW));
            int number = i;
            run(command, stack).ifPresent(error -> errors.put(number, error));
        }
        var stacks = new EnumMap<MatrixMode, List<Matrix4d>>(MatrixMode.class);
        for (MatrixMode each : MatrixMode.values()) stacks.put(each, stack.matrices(each));
        return new StackScene(stacks, mode, cubes, errors);
    }

    private static Optional<Error> run(StackCommand command, MatrixStack stack) {
        try {
            command.run(stack);
            return Optional.empty();
        } catch (IllegalStateException full) {
            StackErrorKind kind =
                    command.op() == StackOp.PUSH
                            ? StackErrorKind.OVERFLOW
                            : StackErrorKind.UNDERFLOW;
            return Optional.of(new Error(kind, full.getMessage()));
        } catch (IllegalArgumentException refused) {
            return Optional.of(new Error(StackErrorKind.VALUE, refused.getMessage()));
        }
    }
}
