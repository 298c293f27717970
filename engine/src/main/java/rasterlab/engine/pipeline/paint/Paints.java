package rasterlab.engine.pipeline.paint;

import java.util.Optional;
import rasterlab.engine.color.Levels;
import rasterlab.engine.light.ToneShading;
import rasterlab.engine.scene.FaceMiddle;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.FlatPaint;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * Makes the paint of a view.
 *
 * <p>The formula's sums are cut to [0, 1] where they are worked out: once per face, per corner or
 * per pixel; {@link Levels} says how.
 *
 * @param lights the light on the faces
 * @param filter of their textures
 * @param fade how they fade with depth
 * @param outline whether faces get edges of 0.96 of their colour, or tone, as flat faces
 */
public record Paints(
        FaceLights lights, TextureMode filter, Optional<DepthFade> fade, boolean outline) {

    /** The vase's own rule. */
    public FacePaint tone() {
        ViewedMesh view = lights.view();
        var fill = new int[view.mesh().faceCount()];
        var edges = new int[outline ? fill.length : 0];
        for (int f = 0; f < fill.length; f++) {
            int rgb = lights.rgb(f);
            double tone = ToneShading.intensity(view.eyeNormal(f, 2), view.seenFromInside(f));
            int alpha = Levels.of(lights.seenMaterial(f).alpha()) << 24;
            fill[f] = alpha | ToneShading.shade(rgb, tone) & 0xFFFFFF;
            if (outline) edges[f] = ToneShading.shade(rgb, ToneShading.OUTLINE * tone);
        }
        return facewise(fill, edges);
    }

    /** The whole formula once for each face. */
    public FacePaint flat() {
        int[] fill = lights.atMiddles();
        return facewise(fill, outlines(fill));
    }

    /** The whole formula at the corners. */
    public FacePaint gouraud() {
        return layered(new CornerColors(lights), outlines());
    }

    /** The whole formula at each pixel. */
    public FacePaint phong() {
        return layered(new PointColors(lights), outlines());
    }

    private int[] outlines() {
        return outline ? outlines(lights.atMiddles()) : new int[0];
    }

    private int[] outlines(int[] fill) {
        var edges = new int[outline ? fill.length : 0];
        for (int f = 0; f < edges.length; f++)
            edges[f] = ToneShading.shade(fill[f], ToneShading.OUTLINE);
        return edges;
    }

    private FacePaint facewise(int[] fill, int[] edges) {
        boolean plain = fade.isEmpty();
        for (int f = 0; f < fill.length && plain; f++)
            plain = fill[f] >>> 24 == 255 && (filter == TextureMode.NONE || untextured(f));
        return plain ? new FlatPaint(fill, edges) : layered(new FaceColors(fill), edges);
    }

    private boolean untextured(int face) {
        return lights.scene().finish(face).texture().isEmpty();
    }

    private FacePaint layered(SurfaceColor light, int[] edges) {
        ViewedMesh view = lights.view();
        Mesh mesh = view.mesh();
        var weights = new CornerWeights(view);
        var texture = new TextureLayer(lights.scene(), view, weights, filter);
        var opaque = new boolean[mesh.faceCount()];
        for (int f = 0; f < opaque.length; f++) {
            opaque[f] = lights.seenMaterial(f).alpha() == 1 && texture.opaque(f);
            if (edges.length > 0 && fade.isPresent())
                edges[f] = fade.get().over(edges[f], FaceMiddle.of(mesh, f, view::eyeZ));
        }
        return new LayeredPaint(weights, light, texture, fade, opaque, edges, view.fit().width());
    }
}
