package rasterlab.engine.pipeline.paint;

import java.util.List;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.texture.DetailLevel;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.visibility.ViewedMesh;

/** The faces' textures, laid over the light on them. */
final class TextureLayer {
    private final Scene scene;
    private final Mesh mesh;
    private final ViewedMesh view;
    private final TextureStep step;
    private final TextureMode filter;
    private final LaidTexture[] laid;
    private final TextureSampler[] samplers;
    private final boolean[] minified;

    /**
     * @param filter none lays nothing
     */
    TextureLayer(Scene scene, ViewedMesh view, CornerWeights weights, TextureMode filter) {
        this.scene = scene;
        this.view = view;
        this.filter = filter;
        mesh = view.mesh();
        step = new TextureStep(view, weights);
        List<Appearance> finishes = scene.finishes();
        laid = new LaidTexture[finishes.size()];
        samplers = new TextureSampler[laid.length];
        for (int i = 0; i < laid.length; i++) {
            if (filter == TextureMode.NONE || finishes.get(i).texture().isEmpty()) continue;
            laid[i] = finishes.get(i).texture().get();
            samplers[i] = new TextureSampler(laid[i].texture(), laid[i].alongS(), laid[i].alongT());
        }
        minified = new boolean[filter == TextureMode.AUTO ? mesh.faceCount() : 0];
        for (int f = 0; f < minified.length; f++)
            minified[f] = lies(f) && step.minified(f, laid(f).texture());
    }

    private LaidTexture laid(int face) {
        return laid[scene.finishNumber(face)];
    }

    /** Whether a face has a texture that is laid. */
    boolean lies(int face) {
        return laid(face) != null;
    }

    /** Whether a face that hides what is behind it still does so with its texture. */
    boolean opaque(int face) {
        return !lies(face) || laid(face).opaque();
    }

    /** Lays a face's texture on the colours of a row. */
    void lay(int face, PixelRow row) {
        if (!lies(face)) return;
        TextureSampler sampler = samplers[scene.finishNumber(face)];
        switch (filter) {
            case NEAREST -> layNearest(face, sampler, row);
            case AFFINE_NEAREST -> layAffine(face, sampler, row);
            case LINEAR -> layLinear(face, sampler, row);
            case MIPMAP -> layMipmap(face, sampler, row);
            case AUTO -> {
                if (minified[face]) layMipmap(face, sampler, row);
                else layLinear(face, sampler, row);
            }
            case NONE -> throw new AssertionError("no texture lies on face " + face);
        }
    }

    private void layNearest(int face, TextureSampler sampler, PixelRow row) {
        var environment = laid(face).environment();
        for (int i = 0; i < row.size; i++) {
            int texel = sampler.nearest(s(face, row, i), t(face, row, i));
            row.argb[i] = environment.combine(row.argb[i], texel);
        }
    }

    private void layLinear(int face, TextureSampler sampler, PixelRow row) {
        var environment = laid(face).environment();
        for (int i = 0; i < row.size; i++) {
            int texel = sampler.linear(s(face, row, i), t(face, row, i));
            row.argb[i] = environment.combine(row.argb[i], texel);
        }
    }

    private void layMipmap(int face, TextureSampler sampler, PixelRow row) {
        var environment = laid(face).environment();
        for (int i = 0; i < row.size; i++) {
            double s = s(face, row, i);
            double t = t(face, row, i);
            double squared =
                    step.squared(face, row.fan[i], s, t, row.depth[i], laid(face).texture());
            int texel = sampler.trilinear(s, t, DetailLevel.quick(squared));
            row.argb[i] = environment.combine(row.argb[i], texel);
        }
    }

    /** λᵢ·zᵢ/z is linear in the pixel and 1 at its own corner: the weights without perspective. */
    private void layAffine(int face, TextureSampler sampler, PixelRow row) {
        if (view.transform().central()) {
            int a = mesh.corner(face, 0);
            for (int i = 0; i < row.size; i++) {
                row.weight0[i] *= view.eyeZ(a) / row.depth[i];
                row.weight1[i] *= view.eyeZ(mesh.corner(face, row.fan[i])) / row.depth[i];
                row.weight2[i] *= view.eyeZ(mesh.corner(face, row.fan[i] + 1)) / row.depth[i];
            }
        }
        layNearest(face, sampler, row);
    }

    private double s(int face, PixelRow row, int i) {
        int fan = row.fan[i];
        return row.weight0[i] * mesh.textureS(face, 0)
                + row.weight1[i] * mesh.textureS(face, fan)
                + row.weight2[i] * mesh.textureS(face, fan + 1);
    }

    private double t(int face, PixelRow row, int i) {
        int fan = row.fan[i];
        return row.weight0[i] * mesh.textureT(face, 0)
                + row.weight1[i] * mesh.textureT(face, fan)
                + row.weight2[i] * mesh.textureT(face, fan + 1);
    }
}
