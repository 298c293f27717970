package rasterlab.engine.pipeline.fast;

import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.scene.VertexQuantity;

/**
 * The frame that is being drawn now, for all stages. One frame at a time; arrays stay for the next.
 */
final class FrameState {
    static final VertexQuantity[] QUANTITIES = VertexQuantity.values();

    TriangleMesh mesh;
    TriangleView view;
    Surface surface;
    Raster picture;

    /** The depths that are tested and kept, one for each cell; empty where none are kept. */
    float[] depth;

    Subpixels subpixels;
    final ScreenVertices vertices = new ScreenVertices();
    int attributeCount;
    int bands;

    /** The quantity of each attribute, in the enumeration's order: colours are the last ones. */
    final VertexQuantity[] attribute = new VertexQuantity[QUANTITIES.length];

    /** Whether a triangle has one colour only, that of its third vertex. */
    boolean flatColors;

    /** Whether a triangle may have to be clipped: its vertices need attributes at once. */
    boolean clips;

    /** Whether any vertex lies beyond a plane. */
    boolean anyBeyond;

    /** Whether each band is cleared before it is drawn, and to what. */
    boolean clears;

    int background;

    void begin(
            TriangleMesh mesh, TriangleView view, Surface surface, Raster picture, float[] depth) {
        this.mesh = mesh;
        this.view = view;
        this.surface = surface;
        if (subpixels == null || !subpixels.of(picture.width(), picture.height()))
            subpixels = new Subpixels(picture.width(), picture.height());
        this.picture = picture;
        this.depth = depth;
        attributeCount = 0;
        for (VertexQuantity quantity : QUANTITIES)
            if (needs(quantity)) attribute[attributeCount++] = quantity;
        flatColors = vertexColors() instanceof Surface.Flat;
        vertices.begin(mesh.vertexCount(), attributeCount);
        clips = false;
        anyBeyond = false;
        bands = (picture.height() + TriangleScan.ROWS - 1) / TriangleScan.ROWS;
    }

    /** Drops what the caller gave, so that a scene can be freed once it is drawn. */
    void end() {
        mesh = null;
        view = null;
        surface = null;
        picture = null;
        depth = null;
    }

    private boolean needs(VertexQuantity quantity) {
        if (!(surface instanceof Surface.PerPixel pixels))
            return isColor(quantity) && quantity != VertexQuantity.ALPHA;
        if (!pixels.colors().wants().contains(quantity)) return false;
        if (quantity == VertexQuantity.ALPHA && pixels.blending().early()) return false;
        if (!isColor(quantity)) mesh.values(quantity);
        return true;
    }

    /** Where colours of vertices come from. */
    Surface.OfVertices vertexColors() {
        return surface instanceof Surface.PerPixel pixels
                ? pixels.under()
                : (Surface.OfVertices) surface;
    }

    /** Whether any attribute is a colour. */
    boolean hasColors() {
        return attributeCount > 0 && isColor(attribute[attributeCount - 1]);
    }

    /** Whether any attribute comes from positions or normals in eye space; those are the first. */
    boolean needsEye() {
        return hasColors()
                || attributeCount > 0 && attribute[0].compareTo(VertexQuantity.NORMAL_Z) <= 0;
    }

    static boolean isColor(VertexQuantity quantity) {
        return quantity.compareTo(VertexQuantity.RED) >= 0;
    }
}
