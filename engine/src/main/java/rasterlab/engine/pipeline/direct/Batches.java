package rasterlab.engine.pipeline.direct;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.engine.pipeline.paint.FaceLights;

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
        int[][] kinds = kinds(lights, opaque, drawn, atPixels);
        List<Batch> batches = new ArrayList<>();
        for (int kind = 0; kind + 1 < kinds.length; kind++)
            if (kinds[kind].length > 0)
                batches.add(new Batch(kind / 2, true, kind % 2 == 1, kinds[kind]));
        int[] glass = kinds[kinds.length - 1];
        addRuns(lights, FarthestFirst.sorted(lights.view(), glass), atPixels, batches);
        return batches;
    }

    /**
     * The drawn faces in ascending order: opaque ones of each finish, those whose light is mixed
     * from the corners before the others, then all transparent ones.
     */
    private static int[][] kinds(
            FaceLights lights, boolean[] opaque, boolean[] drawn, boolean[] atPixels) {
        int glass = 2 * lights.scene().finishes().size();
        int[] kindOf = new int[opaque.length];
        int[] counts = new int[glass + 1];
        for (int f = 0; f < opaque.length; f++) {
            if (!drawn[f]) continue;
            kindOf[f] = opaque[f] ? 2 * lights.finishOf(f) + (atPixels[f] ? 1 : 0) : glass;
            counts[kindOf[f]]++;
        }
        int[][] kinds = new int[glass + 1][];
        for (int kind = 0; kind <= glass; kind++) kinds[kind] = new int[counts[kind]];
        for (int f = opaque.length - 1; f >= 0; f--)
            if (drawn[f]) kinds[kindOf[f]][--counts[kindOf[f]]] = f;
        return kinds;
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
