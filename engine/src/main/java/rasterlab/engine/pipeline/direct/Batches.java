package rasterlab.engine.pipeline.direct;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.scene.FaceMiddle;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The faces of a scene in the order of drawing, in batches of one finish: all that is opaque, then
 * what is transparent by the mean depth of its corners, the farthest first.
 */
final class Batches {
    private Batches() {}

    /**
     * Faces that are drawn together.
     *
     * @param atPixels whether light is worked out at each pixel, where a look has both ways
     */
    record Batch(int finish, boolean opaque, boolean atPixels, int[] faces) {}

    /**
     * @param drawn the faces that are drawn at all
     * @param atPixels the faces whose light is worked out at each pixel
     */
    static List<Batch> of(
            FaceLights lights, boolean[] opaque, boolean[] drawn, boolean[] atPixels) {
        List<Batch> batches = new ArrayList<>();
        for (int i = 0; i < lights.scene().finishes().size(); i++)
            for (boolean exact : new boolean[] {false, true}) {
                int finish = i;
                int[] faces =
                        IntStream.range(0, opaque.length)
                                .filter(f -> opaque[f] && drawn[f] && atPixels[f] == exact)
                                .filter(f -> lights.finishOf(f) == finish)
                                .toArray();
                if (faces.length > 0) batches.add(new Batch(finish, true, exact, faces));
            }
        addRuns(lights, farthestFirst(lights.view(), opaque, drawn), atPixels, batches);
        return batches;
    }

    private static int[] farthestFirst(ViewedMesh view, boolean[] opaque, boolean[] drawn) {
        return IntStream.range(0, opaque.length)
                .filter(f -> !opaque[f] && drawn[f])
                .boxed()
                .sorted(Comparator.comparingDouble(f -> -FaceMiddle.of(view.mesh(), f, view::eyeZ)))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    private static void addRuns(
            FaceLights lights, int[] ordered, boolean[] atPixels, List<Batch> batches) {
        for (int from = 0, to; from < ordered.length; from = to) {
            int finish = lights.finishOf(ordered[from]);
            to = from + 1;
            boolean exact = atPixels[ordered[from]];
            while (to < ordered.length
                    && lights.finishOf(ordered[to]) == finish
                    && atPixels[ordered[to]] == exact) to++;
            batches.add(new Batch(finish, false, exact, Arrays.copyOfRange(ordered, from, to)));
        }
    }
}
