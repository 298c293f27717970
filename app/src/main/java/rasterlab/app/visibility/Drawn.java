package rasterlab.app.visibility;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.FaceDrawing;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.VisibilityWork;
import rasterlab.engine.visibility.painter.PiecesWalk;

/**
 * All that a method did for a picture, step by step.
 *
 * @param view the faces as the eye saw them
 * @param steps in their order, the first {@value #MOST} of them
 * @param pieces what a step drew where that was only a piece of a face, by the step's place in the
 *     list: x and y of its corners, in pixels
 * @param work of the whole picture
 * @param decision what the steps' values are
 */
record Drawn(
        ViewedMesh view,
        List<VisibilityStep> steps,
        Map<Integer, double[]> pieces,
        VisibilityWork work,
        String decision) {
    /** More steps than anyone goes through. */
    static final int MOST = 200_000;

    Drawn {
        steps = List.copyOf(steps);
        pieces = Map.copyOf(pieces);
    }

    /** The drawn steps; empty for methods without steps, and where the method refuses the scene. */
    static Optional<Drawn> of(RenderRequest request, BooleanSupplier cancelled) {
        Optional<FaceDrawing> drawing = FaceDrawing.of(request).filter(FaceDrawing::hasSteps);
        if (drawing.isEmpty()) return Optional.empty();
        try {
            return Optional.of(of(drawing.get(), cancelled));
        } catch (IllegalArgumentException refused) {
            return Optional.empty(); // The picture says why.
        }
    }

    private static Drawn of(FaceDrawing drawing, BooleanSupplier cancelled) {
        VisibilityWalk walk = drawing.walk(drawing.blank());
        var steps = new ArrayList<VisibilityStep>();
        var pieces = new HashMap<Integer, double[]>();
        while (walk.advance()) {
            check(cancelled);
            if (steps.size() == MOST) continue;
            if (walk instanceof PiecesWalk cutting)
                cutting.piece().ifPresent(piece -> pieces.put(steps.size(), piece));
            steps.add(walk.step());
        }
        String decision = ((SteppedVisibility) drawing.method()).decision();
        return new Drawn(drawing.view(), steps, pieces, walk.work(), decision);
    }

    static void check(BooleanSupplier cancelled) {
        if (cancelled.getAsBoolean()) throw new CancellationException();
    }

    /** How many of the first steps cut something. */
    long cuts(int first) {
        return steps.stream().limit(first).filter(Drawn::isCut).count();
    }

    /** Whether the method cuts while it goes, not before it begins. */
    boolean cutsOnTheWay() {
        return steps.stream().anyMatch(Drawn::isCut);
    }

    static boolean isCut(VisibilityStep step) {
        return step instanceof VisibilityStep.FaceCut
                || step instanceof VisibilityStep.Window window && window.divided();
    }
}
