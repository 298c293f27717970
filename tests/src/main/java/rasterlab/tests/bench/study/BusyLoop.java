package rasterlab.tests.bench.study;

import java.io.IOException;

/** Works until its input ends, as it does when the process that began it is gone. */
final class BusyLoop {
    private BusyLoop() {}

    public static void main(String[] arguments) throws IOException {
        var watch = new Thread(BusyLoop::endWithInput);
        watch.setDaemon(true);
        watch.start();
        System.out.write(1);
        System.out.flush();
        double sum = 0;
        while (sum >= 0) sum += Math.sqrt(sum + 1) % 1;
    }

    private static void endWithInput() {
        try {
            while (System.in.read() >= 0) continue;
        } catch (IOException e) {
            System.err.println(e);
        }
        System.exit(0);
    }
}
