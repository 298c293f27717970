package rasterlab.engine.visibility.painter;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import rasterlab.engine.scene.Mesh;

/**
 * Whether a mesh is one convex closed body: each edge has one face on either side, and no vertex
 * lies beyond the plane of a face. Vertices at equal places are one.
 */
public final class ConvexBody {
    /** How far beyond a plane still counts as in it, as a share of the mesh's size. */
    private static final double TOLERANCE = 1e-9;

    private final Mesh mesh;
    private final int[] place;

    /** An edge as a face walks along it. */
    private record Edge(int from, int to) {}

    private record Place(double x, double y, double z) {}

    private ConvexBody(Mesh mesh) {
        this.mesh = mesh;
        place = new int[mesh.vertexCount()];
        Map<Place, Integer> first = new HashMap<>();
        for (int v = 0; v < place.length; v++) {
            // Adding 0 makes −0 and 0 one.
            var here = new Place(mesh.x(v) + 0.0, mesh.y(v) + 0.0, mesh.z(v) + 0.0);
            Integer earlier = first.putIfAbsent(here, v);
            place[v] = earlier == null ? v : earlier;
        }
    }

    /** The fault by which a mesh is not closed, naming faces; empty if it is closed. */
    public static Optional<String> flaw(Mesh mesh) {
        var body = new ConvexBody(mesh);
        return body.gap().or(body::dent);
    }

    /**
     * @throws IllegalArgumentException naming faces that show it, if the mesh is none
     */
    static void require(Mesh mesh) {
        flaw(mesh)
                .ifPresent(
                        flaw -> {
                            throw refusal(flaw);
                        });
    }

    private Optional<String> gap() {
        Map<Edge, Integer> faceAlong = new HashMap<>();
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                Edge edge = edge(f, k);
                if (edge.from == edge.to) continue;
                Integer other = faceAlong.putIfAbsent(edge, f);
                if (other != null)
                    return Optional.of(
                            "faces %d and %d go the same way along an edge".formatted(other, f));
            }
        for (var along : faceAlong.entrySet()) {
            Edge edge = along.getKey();
            if (!faceAlong.containsKey(new Edge(edge.to, edge.from)))
                return Optional.of(
                        "face %d has no neighbour at its edge from vertex %d to %d"
                                .formatted(along.getValue(), edge.from, edge.to));
        }
        return Optional.empty();
    }

    private Edge edge(int face, int k) {
        int next = (k + 1) % mesh.cornerCount(face);
        return new Edge(place[mesh.corner(face, k)], place[mesh.corner(face, next)]);
    }

    private Optional<String> dent() {
        double allowed = TOLERANCE * size();
        for (int f = 0; f < mesh.faceCount(); f++) {
            double nx = mesh.normalX(f);
            double ny = mesh.normalY(f);
            double nz = mesh.normalZ(f);
            int corner = mesh.corner(f, 0);
            double offset = nx * mesh.x(corner) + ny * mesh.y(corner) + nz * mesh.z(corner);
            for (int g = 0; g < mesh.faceCount(); g++)
                for (int k = 0; k < mesh.cornerCount(g); k++) {
                    int v = mesh.corner(g, k);
                    double beyond = nx * mesh.x(v) + ny * mesh.y(v) + nz * mesh.z(v) - offset;
                    if (beyond > allowed)
                        return Optional.of(
                                "a corner of face %d lies outside face %d, by %s units"
                                        .formatted(g, f, rounded(beyond)));
                }
        }
        return Optional.empty();
    }

    /** Rounds to three digits. */
    private static double rounded(double distance) {
        return Double.isFinite(distance)
                ? new BigDecimal(distance).round(new MathContext(3)).doubleValue()
                : distance;
    }

    /** The largest coordinate. */
    private double size() {
        double size = 0;
        for (int v = 0; v < mesh.vertexCount(); v++)
            size =
                    Math.max(
                            size,
                            Math.max(
                                    Math.abs(mesh.x(v)),
                                    Math.max(Math.abs(mesh.y(v)), Math.abs(mesh.z(v)))));
        return size;
    }

    private static IllegalArgumentException refusal(String shown) {
        return new IllegalArgumentException(
                "the scene must be one convex closed body for method 'convex': " + shown);
    }
}
