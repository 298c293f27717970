package rasterlab.engine.pipeline.wire;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Stream;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.visibility.EyeSegment;
import rasterlab.engine.visibility.ViewedMesh;

/** The edges of a mesh, each once, whichever faces share it. */
final class MeshEdges {

    /**
     * An edge between two vertices.
     *
     * @param one a face that has it
     * @param other another one, or the same where there is none
     * @param shared how many faces have it
     */
    private record Edge(int from, int to, int one, int other, int shared) {
        private Edge alsoOf(int face) {
            return new Edge(from, to, one, face, shared + 1);
        }
    }

    private final Map<Long, Edge> edges = new LinkedHashMap<>();

    private MeshEdges(Mesh mesh) {
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++)
                add(f, mesh.corner(f, k), mesh.corner(f, (k + 1) % mesh.cornerCount(f)));
    }

    private void add(int face, int a, int b) {
        if (a == b) return;
        int from = Math.min(a, b);
        int to = Math.max(a, b);
        long key = (long) from << 32 | to;
        Edge known = edges.get(key);
        edges.put(key, known == null ? new Edge(from, to, face, face, 1) : known.alsoOf(face));
    }

    /** The edges of a view that are outlines, rims or sharp enough creases. */
    static Stream<EyeSegment> shown(ViewedMesh view, double creaseDegrees) {
        return new MeshEdges(view.mesh())
                .edges.values().stream()
                        .filter(edge -> shows(edge, view, creaseDegrees))
                        .map(edge -> EyeSegment.between(view, edge.from, edge.to));
    }

    private static boolean shows(Edge edge, ViewedMesh view, double creaseDegrees) {
        if (edge.shared() != 2 || creaseDegrees == 0) return true;
        if (view.seenFromInside(edge.one()) != view.seenFromInside(edge.other())) return true;
        Mesh mesh = view.mesh();
        double cosine =
                mesh.normalX(edge.one()) * mesh.normalX(edge.other())
                        + mesh.normalY(edge.one()) * mesh.normalY(edge.other())
                        + mesh.normalZ(edge.one()) * mesh.normalZ(edge.other());
        return Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, cosine)))) >= creaseDegrees;
    }
}
