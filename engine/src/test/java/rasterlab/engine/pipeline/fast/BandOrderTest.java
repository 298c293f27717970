package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class BandOrderTest {
    private final BandOrder order = new BandOrder();

    /** A chunk with so many triangles in each band. */
    private static TriangleChunk chunk(int... triangles) {
        var chunk = new TriangleChunk();
        chunk.begin(triangles.length, 0);
        for (int band = 0; band < triangles.length; band++)
            chunk.start[band + 1] = chunk.start[band] + triangles[band];
        return chunk;
    }

    private int[] order(int bands, int chunks, TriangleChunk... sorted) {
        order.find(sorted, chunks, bands);
        return IntStream.range(0, bands).map(order::band).toArray();
    }

    @Test
    void theFullestBandComesFirst() {
        assertArrayEquals(new int[] {2, 0, 3, 1}, order(4, 1, chunk(5, 0, 9, 1)));
    }

    @Test
    void trianglesOfAllChunksCount() {
        assertArrayEquals(new int[] {1, 0, 2}, order(3, 2, chunk(9, 6, 0), chunk(0, 6, 3)));
    }

    @Test
    void chunksOfAnEarlierFrameDoNotCount() {
        assertArrayEquals(new int[] {0, 1}, order(2, 1, chunk(2, 1), chunk(0, 9)));
    }

    @Test
    void equalBandsGoFromTheTop() {
        assertArrayEquals(new int[] {0, 2, 3, 1}, order(4, 1, chunk(3, 0, 3, 3)));
    }

    @Test
    void bandsOfALargerPictureBeforeAreForgotten() {
        order(4, 1, chunk(1, 2, 3, 4));
        assertArrayEquals(new int[] {1, 0}, order(2, 1, chunk(1, 2)));
    }
}
