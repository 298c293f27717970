package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.Semaphore;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rasterlab.app.canvas.PictureMaker;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.raster.Raster;

@Timeout(300)
class ClosedLabTest {
    @Test
    void makerIsClosedOnceAfterTheLastPictureOfTwoThreads() throws InterruptedException {
        var drawing = new CountDownLatch(2);
        var closed = new CountDownLatch(1);
        var mayEnd = new Semaphore(0);
        var failures = new CopyOnWriteArrayList<Throwable>();
        var order = new CopyOnWriteArrayList<String>();
        var maker =
                new PictureMaker() {
                    @Override
                    public Raster picture(RenderRequest request, BooleanSupplier cancelled) {
                        drawing.countDown();
                        mayEnd.acquireUninterruptibly();
                        order.add("drawn");
                        throw new CancellationException();
                    }

                    @Override
                    public void close() {
                        order.add("closed");
                        closed.countDown();
                    }
                };
        var lab = new VisibilityLabModel(new OwnMethods(), maker, event -> {}, failures::add);
        lab.resize(8, 6);
        lab.choose(choice -> choice.withVisibility("painter").withDifference(true));
        drawing.await();
        lab.close();
        mayEnd.release(2);
        closed.await();
        assertEquals(List.of("drawn", "drawn", "closed"), order);
        assertEquals(List.of(), failures);
    }
}
