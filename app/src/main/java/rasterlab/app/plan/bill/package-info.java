/**
 * The bill of a picture in the window: counted work, what it takes, and what a plan would leave.
 *
 * <p>Start with {@link rasterlab.app.plan.bill.PictureBill}.
 */
package rasterlab.app.plan.bill;
