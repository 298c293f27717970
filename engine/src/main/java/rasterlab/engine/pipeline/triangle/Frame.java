package rasterlab.engine.pipeline.triangle;

import java.util.Set;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;

/** What is being drawn now, for all stages. One frame at a time; arrays stay for the next. */
final class Frame {
    private static final VertexQuantity[] QUANTITIES = VertexQuantity.values();

    TriangleMesh mesh;
    TriangleView view;
    Surface surface;
    DepthRaster out;
    Subpixels subpixels;
    final ScreenVertices vertices = new ScreenVertices();
    int attributeCount;
    int bands;

    /** Whether each band is cleared before it is drawn, and to what. */
    boolean clears;

    int background;

    void begin(TriangleMesh mesh, TriangleView view, Surface surface, DepthRaster out) {
        this.mesh = mesh;
        this.view = view;
        this.surface = surface;
        if (this.out == null
                || this.out.width() != out.width()
                || this.out.height() != out.height())
            subpixels = new Subpixels(out.width(), out.height());
        this.out = out;
        attributeCount = surface instanceof Surface.PerPixel pixels ? wanted(pixels).size() : 3;
        vertices.ensure(mesh.vertexCount(), attributeCount);
        bands = (out.height() + TriangleScan.ROWS - 1) / TriangleScan.ROWS;
    }

    private Set<VertexQuantity> wanted(Surface.PerPixel pixels) {
        Set<VertexQuantity> wanted = pixels.colors().wants();
        for (VertexQuantity quantity : QUANTITIES)
            if (wanted.contains(quantity)) mesh.values(quantity);
        return wanted;
    }
}
