package rasterlab.engine.scene.obj;

/**
 * Faces by their corners; each corner names a vertex, and texture coordinates and a normal or
 * {@link #NONE} of them.
 */
final class Faces {
    static final int NONE = -1;

    private final Ints firstCorner = new Ints();
    private final Ints vertex = new Ints();
    private final Ints texture = new Ints();
    private final Ints normal = new Ints();
    private final Ints material = new Ints();
    private final Ints smoothing = new Ints();

    Faces() {
        firstCorner.add(0);
    }

    /** Adds a corner to the face that {@link #close} will end. */
    void corner(int ofVertex, int ofTexture, int ofNormal) {
        vertex.add(ofVertex);
        texture.add(ofTexture);
        normal.add(ofNormal);
    }

    void close(int ofMaterial, int ofSmoothing) {
        firstCorner.add(vertex.size());
        material.add(ofMaterial);
        smoothing.add(ofSmoothing);
    }

    int count() {
        return material.size();
    }

    int corners(int face) {
        return firstCorner.get(face + 1) - firstCorner.get(face);
    }

    int vertex(int face, int corner) {
        return vertex.get(firstCorner.get(face) + corner);
    }

    int texture(int face, int corner) {
        return texture.get(firstCorner.get(face) + corner);
    }

    int normal(int face, int corner) {
        return normal.get(firstCorner.get(face) + corner);
    }

    void setNormal(int face, int corner, int number) {
        normal.set(firstCorner.get(face) + corner, number);
    }

    int material(int face) {
        return material.get(face);
    }

    /** The smoothing group, 0 for none. */
    int smoothing(int face) {
        return smoothing.get(face);
    }
}
