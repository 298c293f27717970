package rasterlab.engine.pipeline.paint;

import java.util.Arrays;
import java.util.List;
import java.util.Set;
import rasterlab.engine.color.Levels;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.light.Material;
import rasterlab.engine.light.PointLighting;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.FaceMiddle;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * A scene's light on its faces, in the world.
 *
 * <p>In perspective the eye is a point. In parallel projection it is infinitely far against the
 * lines of sight, for a local viewer too; with an oblique one these are slanted.
 */
public final class FaceLights {
    private final Scene scene;
    private final ViewedMesh view;
    private final LightModel model;
    private final boolean twoSided;
    private final PointLighting[] lights;

    /**
     * @param view of the scene's mesh
     * @param terms the terms of the formula that are seen
     * @param sides how backs are lit
     */
    public FaceLights(Scene scene, ViewedMesh view, Set<LightTerm> terms, Sides sides) {
        this.scene = scene;
        this.view = view;
        List<Appearance> finishes = scene.finishes();
        model = model(scene, view.transform(), sides);
        twoSided = model.twoSided();
        lights = new PointLighting[finishes.size()];
        for (int i = 0; i < lights.length; i++) {
            Appearance finish = finishes.get(i);
            lights[i] =
                    new PointLighting(
                            model,
                            LightTerm.only(terms, finish.front()),
                            LightTerm.only(terms, finish.back()));
            place(view.transform(), lights[i]);
        }
    }

    private static LightModel model(Scene scene, ViewTransform transform, Sides sides) {
        boolean far = !transform.central();
        LightModel model =
                far
                        ? scene.light()
                                .seenFrom(
                                        true,
                                        -transform.sight(0),
                                        -transform.sight(1),
                                        -transform.sight(2))
                        : scene.light()
                                .seenFrom(
                                        false,
                                        transform.toWorld(0, 0, 0, 0),
                                        transform.toWorld(1, 0, 0, 0),
                                        transform.toWorld(2, 0, 0, 0));
        return new LightModel(
                model.globalAmbient(),
                model.localViewer() && !far,
                sides == Sides.SCENE ? model.twoSided() : sides == Sides.TWO,
                model.reflection(),
                model.lights());
    }

    private static void place(ViewTransform transform, PointLighting lighting) {
        lighting.eye(
                transform.toWorld(0, 0, 0, 0),
                transform.toWorld(1, 0, 0, 0),
                transform.toWorld(2, 0, 0, 0),
                -transform.sight(0),
                -transform.sight(1),
                -transform.sight(2));
    }

    /** The lights as this view has them, in the world. */
    LightModel model() {
        return model;
    }

    public Scene scene() {
        return scene;
    }

    public ViewedMesh view() {
        return view;
    }

    public Mesh mesh() {
        return view.mesh();
    }

    public int finishOf(int face) {
        return scene.finishNumber(face);
    }

    /** Whether a back is lit by itself; otherwise it is lit as the front is. */
    public boolean twoSided() {
        return twoSided;
    }

    /** Whether the picture shows a face's back. */
    public boolean seenFromBehind(int face) {
        return view.seenFromInside(face);
    }

    /** The material of the side that is seen, and lit as such. */
    public Material seenMaterial(int face) {
        Appearance finish = scene.finish(face);
        return twoSided && seenFromBehind(face) ? finish.back() : finish.front();
    }

    /** The lighting of each finish, for one thread. */
    public PointLighting[] forThread() {
        var own = new PointLighting[lights.length];
        for (int i = 0; i < own.length; i++) own[i] = lights[i].forThread();
        return own;
    }

    /** The whole formula once for each face: at the mean of its corners, with its own normal. */
    public int[] atMiddles() {
        return atMiddles(all());
    }

    private boolean[] all() {
        var all = new boolean[mesh().faceCount()];
        Arrays.fill(all, true);
        return all;
    }

    /** The light at the middles of some faces; the others stay 0. */
    public int[] atMiddles(boolean[] wanted) {
        Mesh mesh = mesh();
        PointLighting[] own = forThread();
        var argb = new int[mesh.faceCount()];
        if (mesh.hasColors()) return tintedMiddles(argb, own);
        for (int f = 0; f < argb.length; f++)
            if (wanted[f])
                argb[f] =
                        own[finishOf(f)].argb(
                                FaceMiddle.of(mesh, f, mesh::x),
                                FaceMiddle.of(mesh, f, mesh::y),
                                FaceMiddle.of(mesh, f, mesh::z),
                                mesh.normalX(f),
                                mesh.normalY(f),
                                mesh.normalZ(f),
                                seenFromBehind(f));
        return argb;
    }

    /** The light at the middles where corners have colours: their mean is the face's. */
    private int[] tintedMiddles(int[] argb, PointLighting[] own) {
        Mesh mesh = mesh();
        var rgba = new float[4];
        for (int f = 0; f < argb.length; f++) {
            for (int c = 0; c < 3; c++) rgba[c] = (float) mesh.color(f, c);
            own[finishOf(f)].shadeTinted(
                    FaceMiddle.of(mesh, f, mesh::x),
                    FaceMiddle.of(mesh, f, mesh::y),
                    FaceMiddle.of(mesh, f, mesh::z),
                    mesh.normalX(f),
                    mesh.normalY(f),
                    mesh.normalZ(f),
                    seenFromBehind(f),
                    rgba,
                    0);
            argb[f] = Levels.argb(rgba[0], rgba[1], rgba[2], rgba[3]);
        }
        return argb;
    }

    /** The diffuse colour of a face, 0xRRGGBB, times that of its corners. */
    public int rgb(int face) {
        int rgb = scene.finish(face).rgb();
        if (!mesh().hasColors()) return rgb;
        return Levels.argb(
                        (rgb >> 16 & 255) / 255.0 * mesh().color(face, 0),
                        (rgb >> 8 & 255) / 255.0 * mesh().color(face, 1),
                        (rgb & 255) / 255.0 * mesh().color(face, 2),
                        1)
                & 0xFFFFFF;
    }

    /**
     * The whole formula at each face's corners, with their normals: red, green, blue and alpha, 0
     * to 1, of each corner, counted through all faces.
     */
    public float[] atCorners() {
        return atCorners(all());
    }

    /** The light at the corners of some faces; the corners of the others stay 0. */
    public float[] atCorners(boolean[] wanted) {
        Mesh mesh = mesh();
        PointLighting[] own = forThread();
        var rgba = new float[4 * mesh.totalCorners()];
        boolean tinted = mesh.hasColors();
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; wanted[f] && k < mesh.cornerCount(f); k++)
                if (tinted) tint(own[finishOf(f)], f, k, rgba);
                else light(own[finishOf(f)], f, k, rgba);
        return rgba;
    }

    private void light(PointLighting lighting, int f, int k, float[] rgba) {
        Mesh mesh = mesh();
        int v = mesh.corner(f, k);
        lighting.shade(
                mesh.x(v),
                mesh.y(v),
                mesh.z(v),
                mesh.cornerNormal(f, k, 0),
                mesh.cornerNormal(f, k, 1),
                mesh.cornerNormal(f, k, 2),
                seenFromBehind(f),
                rgba,
                4 * (mesh.firstCorner(f) + k));
    }

    private void tint(PointLighting lighting, int f, int k, float[] rgba) {
        Mesh mesh = mesh();
        int v = mesh.corner(f, k);
        int at = 4 * (mesh.firstCorner(f) + k);
        for (int c = 0; c < 3; c++) rgba[at + c] = (float) mesh.color(f, k, c);
        lighting.shadeTinted(
                mesh.x(v),
                mesh.y(v),
                mesh.z(v),
                mesh.cornerNormal(f, k, 0),
                mesh.cornerNormal(f, k, 1),
                mesh.cornerNormal(f, k, 2),
                seenFromBehind(f),
                rgba,
                at);
    }
}
