package rasterlab.engine.pipeline.fast;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.TriangleMesh;

/** How often each pixel is owned by triangles of either turn, whatever their depth. */
final class Coverage {
    final int[] counterClockwise;
    final int[] clockwise;

    private Coverage(int pixels) {
        counterClockwise = new int[pixels];
        clockwise = new int[pixels];
    }

    static Coverage of(TriangleMesh mesh, TriangleView view, int width, int height) {
        var out = new Raster(width, height);
        var frame = new FrameState();
        frame.begin(mesh, view, new Surface.Flat(VertexColors.own()), out, new float[0]);
        for (int k = 0; k < VertexStage.blocks(mesh); k++) new VertexStage().place(frame, k);
        var coverage = new Coverage(width * height);
        var band = new Band();
        for (int k = 0; k < Binner.chunks(mesh.triangleCount()); k++) {
            var chunk = new TriangleChunk();
            new Binner().run(frame, k, chunk);
            for (int number = 0; number < frame.bands; number++) {
                band.begin(frame, number);
                for (int i = chunk.start[number]; i < chunk.start[number + 1]; i++)
                    coverage.add(frame, chunk, i, band);
            }
        }
        return coverage;
    }

    private void add(FrameState frame, TriangleChunk chunk, int triangle, Band band) {
        int at = 3 * triangle;
        boolean whole = chunk.corners[at] >= 0;
        var vertices = whole ? frame.vertices : chunk.clipped;
        int first = whole ? chunk.corners[at] : ~chunk.corners[at];
        int second = whole ? chunk.corners[at + 1] : ~chunk.corners[at + 1];
        int third = whole ? chunk.corners[at + 2] : ~chunk.corners[at + 2];
        var tiny = new TinyScan();
        if (tiny.load(vertices, first, second, third, band)) {
            tiny.look(band.width);
            int[] counts = tiny.fromBehind ? clockwise : counterClockwise;
            for (int k = 0; k < tiny.count; k++) counts[tiny.cell[k]]++;
        } else addRows(vertices, first, second, third, band);
    }

    private void addRows(ScreenVertices vertices, int first, int second, int third, Band band) {
        var scan = new TriangleScan();
        scan.load(vertices, first, second, third, band);
        scan.scan();
        int[] counts = scan.fromBehind ? clockwise : counterClockwise;
        for (int row = 0; row < scan.rows; row++)
            for (int k = 0; k < scan.count[row]; k++)
                counts[(scan.top + row) * band.width + scan.left[row] + k]++;
    }
}
