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

    /** Faces that are drawn together. */
    record Batch(int finish, boolean opaque, int[] faces) {}

    static List<Batch> of(FaceLights lights, boolean[] opaque) {
        List<Batch> batches = new ArrayList<>();
        for (int i = 0; i < lights.scene().finishes().size(); i++) {
            int finish = i;
            int[] faces =
                    IntStream.range(0, opaque.length)
                            .filter(f -> opaque[f] && lights.finishOf(f) == finish)
                            .toArray();
            if (faces.length > 0) batches.add(new Batch(finish, true, faces));
        }
        addRuns(lights, farthestFirst(lights.view(), opaque), batches);
        return batches;
    }

    private static int[] farthestFirst(ViewedMesh view, boolean[] opaque) {
        return IntStream.range(0, opaque.length)
                .filter(f -> !opaque[f])
                .boxed()
                .sorted(Comparator.comparingDouble(f -> -FaceMiddle.of(view.mesh(), f, view::eyeZ)))
                .mapToInt(Integer::intValue)
                .toArray();
    }

    private static void addRuns(FaceLights lights, int[] ordered, List<Batch> batches) {
        for (int from = 0, to; from < ordered.length; from = to) {
            int finish = lights.finishOf(ordered[from]);
            to = from + 1;
            while (to < ordered.length && lights.finishOf(ordered[to]) == finish) to++;
            batches.add(new Batch(finish, false, Arrays.copyOfRange(ordered, from, to)));
        }
    }
}
