import rasterlab.contract.PlaneRotation;

public class Power implements PlaneRotation {
    record Complex(double re, double im) {
        Complex times(Complex o) {
            return new Complex(re * o.re - im * o.im, re * o.im + im * o.re);
        }

        Complex power(int n) {
            if (n == 0) return new Complex(1, 0);
            Complex half = power(n / 2);
            return n % 2 == 0 ? half.times(half) : half.times(half).times(this);
        }
    }

    public void rotate(double degrees, int times, double[] points) {
        double angle = Math.toRadians(degrees % 360);
        Complex turn = new Complex(1, angle).power(times);
        for (int i = 0; i + 1 < points.length; i += 2) {
            Complex image = new Complex(points[i], points[i + 1]).times(turn);
            points[i] = image.re();
            points[i + 1] = image.im();
        }
    }
}
