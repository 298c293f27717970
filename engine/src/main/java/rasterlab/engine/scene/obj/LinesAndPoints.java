package rasterlab.engine.scene.obj;

/** Lines and points of a model: pairs of vertices, two times the same for a point. */
final class LinesAndPoints {
    private final Ints vertices = new Ints();
    private final Ints materials = new Ints();

    /** Adds a line from each corner to the next. */
    void line(FaceLine line, int material) {
        for (int k = 0; k + 1 < line.vertex.size(); k++)
            add(line.vertex.get(k), line.vertex.get(k + 1), material);
    }

    void points(FaceLine line, int material) {
        for (int k = 0; k < line.vertex.size(); k++)
            add(line.vertex.get(k), line.vertex.get(k), material);
    }

    private void add(int from, int to, int material) {
        vertices.add(from);
        vertices.add(to);
        materials.add(material);
    }

    int count() {
        return materials.size();
    }

    int from(int stroke) {
        return vertices.get(2 * stroke);
    }

    int to(int stroke) {
        return vertices.get(2 * stroke + 1);
    }

    int material(int stroke) {
        return materials.get(stroke);
    }
}
