import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import rasterlab.contract.DepthOrder;
import rasterlab.contract.PieceSink;

public class Tree implements DepthOrder {
    record Point(double x, double y, double z) {
        Point minus(Point o) {
            return new Point(x - o.x, y - o.y, z - o.z);
        }

        Point cross(Point o) {
            return new Point(y * o.z - z * o.y, z * o.x - x * o.z, x * o.y - y * o.x);
        }

        double dot(Point o) {
            return x * o.x + y * o.y + z * o.z;
        }

        Point to(Point o, double t) {
            return new Point(x + t * (o.x - x), y + t * (o.y - y), z + t * (o.z - z));
        }
    }

    record Piece(int number, List<Point> points) {
        double[] corners() {
            double[] all = new double[3 * points.size()];
            int i = 0;
            for (Point p : points) {
                all[i++] = p.x;
                all[i++] = p.y;
                all[i++] = p.z;
            }
            return all;
        }
    }

    record Task(List<Piece> pieces, boolean sorted) {}

    @Override
    public void order(double[][] polygons, double[] eye, PieceSink out) {
        Point e = new Point(eye[0], eye[1], eye[2]);
        List<Piece> all = new ArrayList<>();
        double unit = Math.max(Math.abs(e.x), Math.max(Math.abs(e.y), Math.abs(e.z)));
        for (int k = 0; k < polygons.length; k++) {
            List<Point> points = new ArrayList<>();
            for (int i = 0; i < polygons[k].length; i += 3)
                points.add(new Point(polygons[k][i], polygons[k][i + 1], polygons[k][i + 2]));
            for (double value : polygons[k]) unit = Math.max(unit, Math.abs(value));
            all.add(new Piece(k + 1, points));
        }
        Deque<Task> tasks = new ArrayDeque<>();
        tasks.push(new Task(all, false));
        while (!tasks.isEmpty()) {
            Task task = tasks.pop();
            if (task.sorted)
                for (Piece piece : task.pieces) out.piece(piece.number, piece.corners());
            else if (!task.pieces.isEmpty()) divide(task.pieces, e, 1e-13 * unit, tasks);
        }
    }

    private static void divide(List<Piece> pieces, Point eye, double eps, Deque<Task> tasks) {
        Piece root = pieces.get(pieces.size() - 1);
        Point a = root.points.get(0);
        Point n = new Point(0, 0, 0);
        for (int i = 1; i + 1 < root.points.size(); i++) {
            Point c = root.points.get(i).minus(a).cross(root.points.get(i + 1).minus(a));
            n = new Point(n.x + c.x, n.y + c.y, n.z + c.z);
        }
        double length = Math.sqrt(n.dot(n));
        n = new Point(n.x / length, n.y / length, n.z / length);
        if (n.dot(eye.minus(a)) < 0) n = new Point(-n.x, -n.y, -n.z);
        List<Piece> near = new ArrayList<>();
        List<Piece> level = new ArrayList<>();
        List<Piece> far = new ArrayList<>();
        for (Piece piece : pieces) {
            List<Point> front = new ArrayList<>();
            List<Point> back = new ArrayList<>();
            boolean anyFront = false;
            boolean anyBack = false;
            for (int i = 0; i < piece.points.size(); i++) {
                Point p = piece.points.get(i);
                Point q = piece.points.get((i + 1) % piece.points.size());
                double dp = clean(n.dot(p.minus(a)), eps);
                double dq = clean(n.dot(q.minus(a)), eps);
                if (dp >= 0) front.add(p);
                if (dp <= 0) back.add(p);
                anyFront |= dp > 0;
                anyBack |= dp < 0;
                if (dp * dq < 0) {
                    Point cut = p.to(q, dp / (dp - dq));
                    front.add(cut);
                    back.add(cut);
                }
            }
            if (piece == root || !anyFront && !anyBack) level.add(piece);
            else {
                if (anyFront) near.add(new Piece(piece.number, front));
                if (anyBack) far.add(new Piece(piece.number, back));
            }
        }
        tasks.push(new Task(near, false));
        tasks.push(new Task(level, true));
        tasks.push(new Task(far, false));
    }

    private static double clean(double d, double eps) {
        return Math.abs(d) <= eps ? 0 : d;
    }
}
