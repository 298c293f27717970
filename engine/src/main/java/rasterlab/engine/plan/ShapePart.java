package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.contract.Reflection;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Light;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.shape.Patch;
import rasterlab.engine.scene.shape.SceneShape;

/**
 * A part of a scene that was made from one shape: where it is, its steps, and how much light
 * changes with its normals.
 */
final class ShapePart {
    /**
     * Texels for a pixel, along both axes together: a mipmap has less than two of them in a pixel,
     * and between neighbours the filter is linear.
     */
    private static final double TEXELS = 2 * Math.sqrt(2);

    private final SceneShape shape;
    private final int finish;
    private final double[][] corners;
    private final double reach;
    private final double radius;
    private final Optional<ShapeSteps> full;
    private final double levelsPerRadian;
    private final double levelsPerPixel;
    private final boolean any;
    private final Map<Integer, ShapeSteps> tried = new HashMap<>();
    private final Map<Integer, ShapeSteps> glanced = new HashMap<>();
    private final Map<List<Integer>, BlockBounds> blocks = new HashMap<>();

    ShapePart(Scene scene, SceneShape shape, int finish) {
        this.shape = shape;
        this.finish = finish;
        double[] low = filled(Double.POSITIVE_INFINITY);
        double[] high = filled(Double.NEGATIVE_INFINITY);
        boolean some = false;
        Mesh mesh = scene.mesh();
        for (int f = 0; f < mesh.faceCount(); f++) {
            if (scene.finishNumber(f) != finish) continue;
            some = true;
            for (int k = 0; k < mesh.cornerCount(f); k++)
                stretch(mesh, mesh.corner(f, k), low, high);
        }
        any = some;
        corners = new double[8][3];
        for (int i = 0; i < 8; i++)
            for (int axis = 0; axis < 3; axis++)
                corners[i][axis] = (i >> axis & 1) == 0 ? low[axis] : high[axis];
        reach = farthest(mesh, scene, new double[3]);
        radius = farthest(mesh, scene, new double[] {middle(0), middle(1), middle(2)});
        full = ShapeSteps.found(scene, shape, finish);
        levelsPerRadian = levelsPerRadian(scene, finish);
        levelsPerPixel =
                scene.finishes()
                        .get(finish)
                        .texture()
                        .map(laid -> TEXELS * TextureContrast.of(laid.texture(), 255))
                        .orElse(0.0);
    }

    private double farthest(Mesh mesh, Scene scene, double[] from) {
        double most = 0;
        for (int f = 0; f < mesh.faceCount(); f++) {
            if (scene.finishNumber(f) != finish) continue;
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                int v = mesh.corner(f, k);
                double x = mesh.x(v) - from[0];
                double y = mesh.y(v) - from[1];
                double z = mesh.z(v) - from[2];
                most = Math.max(most, x * x + y * y + z * z);
            }
        }
        return Math.sqrt(most);
    }

    private static double[] filled(double value) {
        return new double[] {value, value, value};
    }

    private static void stretch(Mesh mesh, int v, double[] low, double[] high) {
        double[] at = {mesh.x(v), mesh.y(v), mesh.z(v)};
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = Math.min(low[axis], at[axis]);
            high[axis] = Math.max(high[axis], at[axis]);
        }
    }

    SceneShape shape() {
        return shape;
    }

    int finish() {
        return finish;
    }

    /** Whether the scene has faces of it. */
    boolean any() {
        return any;
    }

    /** The corners of the box that holds it, in the world. */
    double[][] corners() {
        return corners;
    }

    /** The middle of that box. */
    double middle(int axis) {
        return (corners[0][axis] + corners[7][axis]) / 2;
    }

    /** The farthest that any of it is from the middle, world units. */
    double radius() {
        return radius;
    }

    /** The farthest that any of it is from the origin, world units. */
    double reach() {
        return reach;
    }

    /** The steps that its faces were made in; empty where they were not. */
    Optional<ShapeSteps> full() {
        return full;
    }

    /**
     * Whether it may have fewer faces at all. A mipmap's level is one for each face: on a large
     * flat one, which no rise keeps small, far and near places would share it.
     */
    boolean mayBeCoarser() {
        return levelsPerPixel == 0 || shape.patches().stream().noneMatch(Patch::isFlat);
    }

    /** The fewest steps of u that it is made in. */
    int fewestColumns() {
        return ShapeSteps.fewestColumns(shape);
    }

    /** The fewest steps of v that it is made in. */
    int fewestRows() {
        return ShapeSteps.fewestRows(shape);
    }

    /** Levels for each radian that a normal turns. */
    double levelsPerRadian() {
        return levelsPerRadian;
    }

    /** Levels for each pixel that its texture is moved by; 0 where it has none. */
    double levelsPerPixel() {
        return levelsPerPixel;
    }

    /** Measures the shape made in steps, once for the same ones. */
    ShapeSteps steps(int u, int v) {
        return tried.computeIfAbsent(u << 16 | v, key -> ShapeSteps.of(shape, u, v));
    }

    /**
     * Looks at a few places of the shape made in steps, once for the same ones: a bound from below.
     */
    ShapeSteps atLeast(int u, int v) {
        return glanced.computeIfAbsent(u << 16 | v, key -> ShapeSteps.atLeast(shape, u, v));
    }

    /** Measures blocks of the cells that steps make, once for the same ones. */
    BlockBounds blocks(int u, int v, int side) {
        return blocks.computeIfAbsent(
                List.of(u, v, side), key -> BlockBounds.of(shape, u, v, side));
    }

    private static double levelsPerRadian(Scene scene, int finish) {
        Appearance look = scene.finishes().get(finish);
        return Math.max(
                levelsPerRadian(scene, look.front().surface()),
                levelsPerRadian(scene, look.back().surface()));
    }

    private static double levelsPerRadian(Scene scene, SurfaceMaterial surface) {
        double sum = 0;
        List<Light> lights = new ArrayList<>(scene.light().model().lights());
        scene.light().atEye().ifPresent(eye -> lights.add(Light.from(eye, 0, 0, 1)));
        Reflection reflection = scene.light().model().reflection();
        double turns = reflection == Reflection.BLINN_PHONG ? 1 : 2;
        double slope = reflection == Reflection.LAMBERT ? 0 : turns * steepest(surface.shininess());
        for (Light light : lights)
            sum +=
                    most(surface.diffuse(), light.source().diffuse())
                            + slope * most(surface.specular(), light.source().specular());
        return 255 * sum;
    }

    /** The most of |d cosˢ φ/dφ|: √s·((s − 1)/s)^((s − 1)/2). */
    private static double steepest(double s) {
        if (s <= 1) return 1;
        return Math.sqrt(s) * Math.pow((s - 1) / s, (s - 1) / 2);
    }

    private static double most(double[] surface, double[] light) {
        double most = 0;
        for (int c = 0; c < 3; c++) most = Math.max(most, surface[c] * light[c]);
        return most;
    }
}
