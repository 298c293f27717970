import rasterlab.contract.PixelGrid;
import rasterlab.contract.SeedFiller;

/** Fills a region. So far it leaves the picture as it is. */
public class MyFill implements SeedFiller {
    @Override
    public void fill(PixelGrid picture, int x, int y, int with, int connectivity) {}
}
