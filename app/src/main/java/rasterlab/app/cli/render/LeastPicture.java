package rasterlab.app.cli.render;

import java.util.Optional;
import picocli.CommandLine.Option;
import rasterlab.app.outcome.Complaint;
import rasterlab.engine.pipeline.Choice;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.plan.Plan;
import rasterlab.engine.plan.Planner;
import rasterlab.engine.plan.ShadingChoice;
import rasterlab.engine.plan.Tolerance;

/** Options of a picture that is drawn by the least model within a tolerance. */
final class LeastPicture {
    private static final double USUAL_LEVELS = 2;

    @Option(
            names = "--tolerance",
            paramLabel = "PX",
            description =
                    "draws the least model that is enough, as ./lab plan finds it: nothing is farther out"
                            + " of place than this, in pixels, above 0 to 64",
            converter = ToleranceOption.PixelsReader.class)
    private Double pixels;

    @Option(
            names = "--levels",
            paramLabel = "L",
            description =
                    "with --tolerance: how far a channel may be off, in levels of 0 to 255; 2 unless"
                            + " given; without it: --shading auto takes the cheapest of flat, gouraud"
                            + " and phong that is proved to be within L levels of phong",
            converter = ToleranceOption.LevelsReader.class)
    private Double levels;

    /**
     * The plan of a picture that is asked for; empty without a tolerance.
     *
     * @param asked whose visibility, shading and texture are chosen anew
     */
    Optional<Plan> plan(RenderRequest asked) {
        if (pixels == null) return Optional.empty();
        requireFaces(asked);
        Tolerance tolerance = ToleranceOption.of(pixels, levels == null ? USUAL_LEVELS : levels, 0);
        try {
            return Optional.of(new Planner().plan(asked, tolerance));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput(e.getMessage());
        }
    }

    /**
     * The shading of a picture that leaves it open, by the levels that it may be off; empty where
     * no levels are given, or a plan decides.
     */
    Optional<Choice> shading(RenderRequest asked) {
        if (levels == null || pixels != null) return Optional.empty();
        if (asked.look().shading() != ShadingMethod.AUTO
                || asked.visibility().equals(Renderer.SURFACES))
            throw Complaint.badInput("--levels needs --tolerance, or faces and --shading auto");
        try {
            return Optional.of(ShadingChoice.of(asked, levels));
        } catch (IllegalArgumentException e) {
            throw Complaint.badInput("--" + e.getMessage());
        }
    }

    /** Refuses what a plan says nothing about, or chooses itself. */
    private static void requireFaces(RenderRequest asked) {
        if (!asked.visibility().equals(Renderer.AUTO))
            throw Complaint.badInput(
                    "--tolerance chooses the visibility method itself, got " + asked.visibility());
        if (asked.look().shading() == ShadingMethod.WIRE)
            throw Complaint.badInput("--tolerance needs faces; --shading wire has none");
        if (asked.look().stereo().isPresent())
            throw Complaint.badInput("--tolerance is for one eye, not for two");
    }
}
