package rasterlab.engine.pipeline.paint;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.texture.DetailLevel;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * How far one step on the screen goes in a texture.
 *
 * <p>With s = Σ λᵢ·sᵢ and λᵢ = z·λ'ᵢ, λ'ᵢ linear in the pixel, the derivative to the right is
 * exactly {@code ds/dx = z·(Σ sᵢ·aᵢ − s·Σ aᵢ)}, aᵢ being the step of λ'ᵢ; downwards alike. In
 * parallel projection z counts as 1.
 */
final class TextureStep {
    private final ViewedMesh view;
    private final Mesh mesh;
    private final CornerWeights weights;

    TextureStep(ViewedMesh view, CornerWeights weights) {
        this.view = view;
        mesh = view.mesh();
        this.weights = weights;
    }

    /** ρ² of {@link DetailLevel} at a place of a face, from its s, t and depth. */
    double squared(int face, int fan, double s, double t, double depth, Texture texture) {
        double z = view.transform().central() ? depth : 1;
        double dsdx = 0;
        double dtdx = 0;
        double dsdy = 0;
        double dtdy = 0;
        for (int i = 0; i < 3; i++) {
            int corner = i == 0 ? 0 : fan + i - 1;
            double toS = mesh.textureS(face, corner) - s;
            double toT = mesh.textureT(face, corner) - t;
            double right = weights.perColumn(face, fan, i);
            double down = weights.perRow(face, fan, i);
            dsdx += toS * right;
            dtdx += toT * right;
            dsdy += toS * down;
            dtdy += toT * down;
        }
        return z
                * z
                * DetailLevel.squaredStep(
                        dsdx, dtdx, dsdy, dtdy, texture.width(), texture.height());
    }

    /**
     * Whether some pixel of a face may step over more than a texel; never false where one does.
     *
     * <p>With N = Σ λ'ᵢ·sᵢ and D = 1/z, ds/dx = (N'·D − N·D')/D². The numerator is linear in the
     * pixel, so it is largest at a corner; D is smallest at the farthest corner.
     */
    boolean minified(int face, Texture texture) {
        double farthest = 0;
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            double z = view.eyeZ(mesh.corner(face, k));
            if (z < view.near()) return true;
            farthest = Math.max(farthest, view.transform().central() ? z : 1);
        }
        for (int fan = 1; fan + 1 < mesh.cornerCount(face); fan++)
            for (int i = 0; i < 3; i++) {
                int corner = i == 0 ? 0 : fan + i - 1;
                double z = view.transform().central() ? view.eyeZ(mesh.corner(face, corner)) : 1;
                double step =
                        squared(
                                face,
                                fan,
                                mesh.textureS(face, corner),
                                mesh.textureT(face, corner),
                                z,
                                texture);
                double worst = farthest * farthest / (z * z);
                if (step * worst * worst > 1) return true;
            }
        return false;
    }
}
