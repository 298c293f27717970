package rasterlab.engine.transform;

/** The four operations of doubles, so that they can be counted while a method runs. */
public interface Arithmetic {
    /** Just computes; the just-in-time compiler leaves nothing of it but the operation. */
    Arithmetic PLAIN = new Plain();

    double plus(double a, double b);

    double minus(double a, double b);

    double times(double a, double b);

    /** See {@link #PLAIN}. */
    final class Plain implements Arithmetic {
        private Plain() {}

        @Override
        public double plus(double a, double b) {
            return a + b;
        }

        @Override
        public double minus(double a, double b) {
            return a - b;
        }

        @Override
        public double times(double a, double b) {
            return a * b;
        }
    }
}
