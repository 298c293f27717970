package rasterlab.engine.scene.obj;

import java.util.List;

/**
 * A model as it was read: flat convex faces with an area, the corners of each naming a position, a
 * normal and, where the file has them, texture coordinates; lines and points; one material for
 * each.
 */
public final class ObjModel {
    private final double[] positions;
    private final double[] colors;
    private final double[] places;
    private final double[] normals;
    private final Faces faces;
    private final LinesAndPoints strokes;
    private final List<ObjMaterial> materials;
    private final List<String> notes;

    ObjModel(
            Vertices vertices,
            double[] normals,
            Faces faces,
            LinesAndPoints strokes,
            List<ObjMaterial> materials,
            List<String> notes) {
        positions = vertices.positions.all();
        colors = vertices.colors.all();
        places = vertices.places.all();
        this.normals = normals;
        this.faces = faces;
        this.strokes = strokes;
        this.materials = materials;
        this.notes = notes;
    }

    /**
     * Notes on the things that were passed over or changed, one sentence each, with the place of
     * the first.
     */
    public List<String> notes() {
        return notes;
    }

    /**
     * The materials in the order of the files; faces above the first usemtl have one whose name is
     * empty.
     */
    public List<ObjMaterial> materials() {
        return materials;
    }

    /** x, y, z of each vertex, a copy. */
    public double[] positions() {
        return positions.clone();
    }

    /** Red, green and blue of each vertex from 0 to 1, a copy; empty where the file has none. */
    public double[] colors() {
        return colors.clone();
    }

    /** s and t of each place of a texture, a copy. */
    public double[] texturePlaces() {
        return places.clone();
    }

    /** x, y, z of each normal, of length 1, a copy; those the file lacks come last. */
    public double[] normals() {
        return normals.clone();
    }

    public int faceCount() {
        return faces.count();
    }

    public int cornerCount(int face) {
        return faces.corners(face);
    }

    /** The number of a corner's position. */
    public int position(int face, int corner) {
        return faces.vertex(face, corner);
    }

    /** The number of a corner's place of the texture, or −1. */
    public int texturePlace(int face, int corner) {
        return faces.texture(face, corner);
    }

    /** The number of a corner's normal. */
    public int normal(int face, int corner) {
        return faces.normal(face, corner);
    }

    /** The number of a face's material. */
    public int material(int face) {
        return faces.material(face);
    }

    /** Number of straight lines and points. */
    public int strokeCount() {
        return strokes.count();
    }

    /** The number of the position where a line begins, or of a point. */
    public int strokeFrom(int stroke) {
        return strokes.from(stroke);
    }

    /** The number of the position where a line ends, or of a point. */
    public int strokeTo(int stroke) {
        return strokes.to(stroke);
    }

    /** The number of a line's or point's material. */
    public int strokeMaterial(int stroke) {
        return strokes.material(stroke);
    }
}
