package rasterlab.tests.bench.plan;

import java.io.PrintStream;
import java.util.List;
import java.util.Locale;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.Planner;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.shape.Patch;
import rasterlab.engine.scene.shape.ShapeSurfaces;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.transform.PictureFit;
import rasterlab.tests.bench.language.BenchWords;

/**
 * Faces that plans make of round bodies, beside the fewest there can be.
 *
 * <p>Both are in even steps of two directions, and what they and the full mesh are off the surface
 * is half of the tolerance at most. Levels are many, so that no light decides, and the projection
 * is parallel, so that a pixel is as large everywhere. The disc that the vase stands on is flat: it
 * has one face for each step once round.
 *
 * @param scene its name
 * @param pixels of the tolerance
 * @param planned faces of the plan's mesh
 * @param fewest by search
 */
public record FaceCounts(String scene, double pixels, int planned, int fewest) {
    /** The most faces beside the fewest. */
    static final double MOST = 1.15;

    private static final List<String> SCENES = List.of("sphere", "torus", "revolution");
    private static final List<Double> TOLERANCES = List.of(0.25, 0.5, 1.0);

    private static final int DETAIL = 512;
    private static final int WIDTH = 800;
    private static final int HEIGHT = 600;

    public FaceCounts {
        Bounds.requireAtLeast("fewest", fewest, 1);
    }

    static FaceCounts of(String name, double pixels) {
        Scene scene = Scenes.named(name, DETAIL);
        var asked =
                new RenderRequest(
                        scene,
                        "pipeline",
                        "phong",
                        "parallel",
                        scene.defaultCamera(),
                        WIDTH,
                        HEIGHT);
        Plan plan = new Planner(1, Costs.measured()).plan(asked, new Tolerance(pixels, 255, 0));
        List<Patch> patches =
                ((ShapeSurfaces) scene.surfaces().orElseThrow()).shapes().get(0).patches();
        Patch patch = patches.get(0);
        double perUnit = PictureFit.of(WIDTH, HEIGHT, scene.pictureScale()).pixelsPerUnit();
        double own = FewestFaces.distance(patch, DETAIL, DETAIL / 2);
        FewestFaces fewest =
                FewestFaces.of(
                        patch, patches.size() - 1, pixels / 2 / perUnit - own, DETAIL, DETAIL / 2);
        return new FaceCounts(
                name, pixels, plan.least().scene().mesh().faceCount(), fewest.faces());
    }

    double ratio() {
        return (double) planned / fewest;
    }

    /** Writes a line for each body and tolerance. */
    public static void print(BenchWords words, PrintStream out) {
        out.println(words.head("head.faces"));
        for (String scene : SCENES)
            for (double pixels : TOLERANCES) out.println(of(scene, pixels).line(words));
    }

    String line(BenchWords words) {
        return String.format(
                Locale.ROOT,
                "%s within %.2f px | planned %d | fewest %d | %.3f | %.2f | %s",
                scene,
                pixels,
                planned,
                fewest,
                ratio(),
                MOST,
                words.text(ratio() <= MOST ? "yes" : "no"));
    }
}
