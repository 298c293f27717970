package rasterlab.engine.scene.shape;

import java.util.Optional;
import rasterlab.engine.scene.Mesh;

/**
 * A shape with the steps by which meshes of it are made.
 *
 * <p>A patch of m by n steps has (m + 1)·(n + 1) vertices, those of u one after another, so a seam
 * is there twice, at bit-equal places, with texture coordinates of both its sides. A pole is there
 * once for each step of u, with normal and texture coordinates of the middle of the step; the
 * triangle that would have no area there is left out.
 *
 * @param uSteps at least 1, and at least 3 where u goes once round
 * @param vSteps at least 1, 2 between two poles and 3 where v goes once round
 */
public record Tessellation(SceneShape shape, int uSteps, int vSteps) {
    /** The most triangles: their vertex numbers fill an array of 768 MiB. */
    private static final int MOST_TRIANGLES = 1 << 26;

    public Tessellation {
        long triangles = 0;
        for (Patch patch : shape.patches()) {
            int v = patch.vSteps(vSteps);
            require("u", patch.u().round() ? 3 : 1, uSteps);
            require("v", fewestOfV(patch), v);
            triangles += 2L * uSteps * v;
        }
        if (triangles > MOST_TRIANGLES)
            throw new IllegalArgumentException(
                    "%d×%d steps make %d triangles, at most %d are allowed"
                            .formatted(uSteps, vSteps, triangles, MOST_TRIANGLES));
    }

    private static int fewestOfV(Patch patch) {
        if (patch.v().round()) return 3;
        return patch.isPole(patch.v().from()) && patch.isPole(patch.v().to()) ? 2 : 1;
    }

    private static void require(String name, int fewest, int steps) {
        if (steps < fewest)
            throw new IllegalArgumentException(
                    "steps of %s must be at least %d, got %d".formatted(name, fewest, steps));
    }

    /** Flat faces over shared vertices, with normals and texture coordinates of their corners. */
    public Mesh faces() {
        return new FaceGrid(this, Optional.empty()).mesh();
    }

    /**
     * The faces, but for blocks of cells that are joined: each of those is coarser, without gaps.
     */
    public Mesh faces(JoinedBlocks joins) {
        return new FaceGrid(this, Optional.of(joins)).mesh();
    }
}
