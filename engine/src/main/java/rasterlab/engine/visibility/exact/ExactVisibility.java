package rasterlab.engine.visibility.exact;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.PixelPoint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityWork;

/**
 * The reference of hidden surfaces: the nearest face at each pixel, compared without error.
 *
 * <p>What is exact is stated here. The mesh, the matrix from world to eye and the picture's fit are
 * taken as the doubles they are. A pixel is looked at in its {@link PixelPoint}. A face owns it
 * where the line of sight through that point passes between the face's corners ({@link SeenFace}).
 * How near the face is there tells the plane of its {@link PlaneClasses}: the plane of the largest
 * face of those that are in one plane within the rounding of turned coordinates. The nearest face
 * is seen, of equally near ones the one that comes first in the mesh.
 *
 * <p>So of faces in one plane the first wins at all pixels, not at those where rounding prefers it.
 * All that follows from the stated rules is decided without rounding: {@link PixelSign} and {@link
 * Nearness} ask doubles first, with a bound of their error, and then whole numbers.
 */
public final class ExactVisibility implements Visibility {
    @Override
    public VisibilityWork draw(
            ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        Cancellation.check(cancelled);
        var nearness = new Nearness[view.mesh().faceCount()];
        SeenFace[] faces = faces(view, nearness, cancelled);
        int[][] inRow = rows(faces, out.height());
        var compared = new LongAdder();
        var painted = new LongAdder();
        var tested = new LongAdder();
        IntStream.range(0, out.height())
                .parallel()
                .forEach(
                        row -> {
                            Cancellation.check(cancelled);
                            var layers = new RowLayers(out.width(), paint, nearness);
                            layers.begin(row);
                            for (int i : inRow[row])
                                faces[i].row(
                                        row, (from, to) -> layers.add(faces[i].face(), from, to));
                            layers.paint(out);
                            compared.add(layers.compared());
                            painted.add(layers.painted());
                            tested.add(inRow[row].length);
                        });
        return new VisibilityWork(tested.sum(), compared.sum(), painted.sum(), 0);
    }

    /** All faces but those that are seen edge-on, which cover nothing. */
    private static SeenFace[] faces(
            ViewedMesh view, Nearness[] nearness, BooleanSupplier cancelled) {
        var planes = new PlaneClasses(view.mesh());
        var sightings = new Sightings(view);
        List<Optional<PlaneSight>> sights =
                IntStream.range(0, nearness.length)
                        .parallel()
                        .mapToObj(
                                face ->
                                        planes.of(face) == face
                                                ? sightings.plane(face)
                                                : Optional.<PlaneSight>empty())
                        .toList();
        return IntStream.range(0, nearness.length)
                .parallel()
                .peek(face -> Cancellation.check(cancelled))
                .filter(face -> sights.get(planes.of(face)).isPresent())
                .mapToObj(
                        face -> {
                            PlaneSight plane = sights.get(planes.of(face)).orElseThrow();
                            nearness[face] = plane.nearness();
                            return new SeenFace(sightings, face, plane.limits());
                        })
                .toArray(SeenFace[]::new);
    }

    /** The places of the faces that may own a pixel, in the mesh's order, for each row. */
    private static int[][] rows(SeenFace[] faces, int height) {
        var count = new int[height];
        for (SeenFace face : faces) for (int y = face.top(); y < face.bottom(); y++) count[y]++;
        var rows = new int[height][];
        for (int y = 0; y < height; y++) rows[y] = new int[count[y]];
        Arrays.fill(count, 0);
        for (int i = 0; i < faces.length; i++)
            for (int y = faces[i].top(); y < faces[i].bottom(); y++) rows[y][count[y]++] = i;
        return rows;
    }
}
