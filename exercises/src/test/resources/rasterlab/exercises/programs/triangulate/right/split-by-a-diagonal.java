import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Stream;
import rasterlab.contract.Triangulator;

/** Divides the polygon in two by a diagonal, and each part again. */
public class Splitting implements Triangulator {
    record Vertex(int number, double x, double y) {
        double turn(Vertex b, Vertex c) {
            return (b.x - x) * (c.y - y) - (b.y - y) * (c.x - x);
        }

        boolean isAt(Vertex other) {
            return x == other.x && y == other.y;
        }

        boolean before(Vertex other) {
            return x < other.x || x == other.x && y < other.y;
        }
    }

    @Override
    public int[] triangulate(double[] x, double[] y) {
        List<Vertex> ring = new ArrayList<>();
        for (int i = 0; i < x.length; i++) {
            Vertex next = new Vertex(i, x[i], y[i]);
            if (ring.isEmpty() || !ring.get(ring.size() - 1).isAt(next)) ring.add(next);
        }
        while (ring.size() > 1 && ring.get(0).isAt(ring.get(ring.size() - 1))) ring.remove(ring.size() - 1);
        if (ring.size() < 3) return new int[0];
        int least = least(ring);
        if (at(ring, least - 1).turn(at(ring, least), at(ring, least + 1)) < 0) Collections.reverse(ring);
        return triangles(ring).mapToInt(Integer::intValue).toArray();
    }

    private static Vertex at(List<Vertex> ring, int k) {
        return ring.get(Math.floorMod(k, ring.size()));
    }

    private static int least(List<Vertex> ring) {
        int least = 0;
        for (int k = 1; k < ring.size(); k++) if (ring.get(k).before(ring.get(least))) least = k;
        return least;
    }

    private static Stream<Integer> triangles(List<Vertex> ring) {
        if (ring.size() == 3) return ring.stream().map(Vertex::number);
        var turned = new ArrayList<>(ring);
        Collections.rotate(turned, -least(ring));
        int n = turned.size();
        Vertex b = turned.get(0);
        Vertex c = turned.get(1);
        Vertex a = turned.get(n - 1);
        int farthest = -1;
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 2; k < n - 1; k++) {
            Vertex p = turned.get(k);
            if (a.turn(b, p) < 0 || b.turn(c, p) < 0 || c.turn(a, p) < 0) continue;
            if (c.turn(a, p) > most) farthest = k;
            most = Math.max(most, c.turn(a, p));
        }
        if (farthest < 0)
            return Stream.concat(
                    Stream.of(a, b, c).map(Vertex::number), triangles(turned.subList(1, n)));
        var first = turned.subList(0, farthest + 1);
        var second = new ArrayList<>(turned.subList(farthest, n));
        second.add(b);
        return Arrays.asList(first, second).stream().flatMap(Splitting::triangles);
    }
}
