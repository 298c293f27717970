/**
 * The lab of inputs that are a row of pixels without faces: depths that a buffer stores, places of
 * a texture along a row, footprints that a filter makes into colours.
 *
 * <p>Each band of the stage is the row as it is right or as a method has it, from the first pixel
 * on the left. Start with {@link rasterlab.app.row.RowScene}; {@link rasterlab.app.row.RowLabModel}
 * knows no Swing. The lab stands in the tabs of hidden surfaces and of light.
 */
package rasterlab.app.row;
