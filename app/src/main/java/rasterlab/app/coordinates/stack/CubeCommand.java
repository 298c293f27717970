package rasterlab.app.coordinates.stack;

import java.util.List;
import java.util.Optional;
import org.joml.Matrix4d;
import rasterlab.app.coordinates.figure.ChainCommand;
import rasterlab.app.coordinates.figure.Chains;
import rasterlab.app.coordinates.figure.Wireframe;

/**
 * The shell command that computes where the corners of the newest cube go. The program itself,
 * which keeps matrices and brings them back, has none.
 */
final class CubeCommand {
    private CubeCommand() {}

    /** The command; empty before a cube is drawn. */
    static Optional<String> of(StackScene scene) {
        List<Matrix4d> cubes = scene.cubes();
        if (cubes.isEmpty()) return Optional.empty();
        Matrix4d newest = cubes.get(cubes.size() - 1);
        return Optional.of(
                ChainCommand.of(
                        List.of(ChainCommand.cells(4, Chains.cells(newest))),
                        3,
                        Wireframe.cube().numbers(),
                        "double"));
    }
}
